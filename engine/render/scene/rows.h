// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/scene/render_scene.h"
#include "shared/scene.h"

namespace sl {

/// Materials as shaders and the path tracer read them.
struct MaterialRows {
    std::vector<MaterialParams> materials;
    std::vector<PictureParams> pictures;  ///< of those that read some
};
/// A row of `materials` per entry of a scene, in their order; each knows the row of its pictures.
MaterialRows material_rows(const RenderScene& scene);

/// Turns normals right under any scale or mirror: the cofactors of the linear part.
mat4 normal_matrix(const mat4& world_from_local);

}  // namespace sl
