// SPDX-License-Identifier: MIT
#include "engine/render/scene/facing_runs.h"

namespace sl {

std::vector<IndexRun> facing_runs(const MeshData& mesh, const mat4& world_from_local, vec4 eye) {
    if (mesh.facings.empty()) return {{0, static_cast<std::uint32_t>(mesh.indices.size())}};
    const vec4 local = glm::inverse(world_from_local) * eye;
    std::vector<IndexRun> runs;
    for (const MeshData::Facing& facing : mesh.facings) {
        // NaN, of a matrix without an inverse, leaves nothing out.
        if (facing.sign * local[facing.axis] <= facing.lowest * local.w) continue;
        if (!runs.empty() && runs.back().first + runs.back().count == facing.first) {
            runs.back().count += facing.count;
        } else {
            runs.push_back({facing.first, facing.count});
        }
    }
    return runs;
}

}  // namespace sl
