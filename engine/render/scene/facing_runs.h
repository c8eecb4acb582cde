// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/mesh_data.h"

namespace sl {

/// Part of a mesh's indices.
struct IndexRun {
    std::uint32_t first = 0, count = 0;
};

/// The fewest runs that hold all triangles whose fronts may be seen from `eye`: a place (w = 1), or from infinitely far off
/// in a direction (w = 0). Of a mesh that tells nothing of where it faces, all.
std::vector<IndexRun> facing_runs(const MeshData& mesh, const mat4& world_from_local, vec4 eye);

}  // namespace sl
