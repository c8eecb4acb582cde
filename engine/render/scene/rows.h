// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/scene/render_scene.h"
#include "shared/scene.h"

namespace sl {

/// A material as shaders and the path tracer read it.
MaterialParams material_params(const MaterialEntry& entry);

/// Turns normals right under any scale or mirror: the cofactors of the linear part.
mat4 normal_matrix(const mat4& world_from_local);

}  // namespace sl
