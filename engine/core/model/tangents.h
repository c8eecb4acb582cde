// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/model/model.h"

namespace sl {

/// Gives a mesh the tangents that its normal texture needs, from positions, normals and the coordinates that the texture
/// reads: MikkTSpace's, but for the last digits. Vertices between triangles on which the texture is mirrored and others on
/// which it is not are parted, so there may be more of them. `mesh.pictured` must be there.
void make_tangents(ModelPrimitive& primitive, const ModelTexture& normal_texture);

}  // namespace sl
