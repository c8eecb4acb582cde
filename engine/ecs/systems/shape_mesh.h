// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/mesh_data.h"
#include "engine/ecs/components/shape.h"

namespace sl {

/// Triangles of a shape with outward normals; uv 0 to 1 over each face. Corners of a disc and of a sphere lie
/// exactly on it, so their surface is inside by at most radius / 800 (64 corners round, 32 from pole to
/// pole). Sizes that are negative or not finite count as 0, and a size of 0 gives flat triangles without
/// area.
MeshData make_shape_mesh(const Shape& shape);

}  // namespace sl
