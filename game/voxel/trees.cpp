// SPDX-License-Identifier: MIT
#include "game/voxel/trees.h"

#include "game/voxel/generators.h"
#include "game/voxel/lattice_noise.h"

namespace sl {

void grow_tree(VoxelVolume& volume, ivec3 foot, const TreeShape& shape, std::uint32_t seed) {
    volume.fill(foot, foot + shape.trunk, Block::log);
    // Distances are doubled so that an even trunk has its crown's middle between two blocks.
    const ivec3 middle = 2 * foot + ivec3(shape.trunk.x, 2 * shape.trunk.y, shape.trunk.z);
    const ivec3 low = middle / 2 - shape.crown - 1;
    const ivec3 high = middle / 2 + shape.crown + 2;
    for (int y = low.y; y < high.y; ++y) {
        for (int z = low.z; z < high.z; ++z) {
            for (int x = low.x; x < high.x; ++x) {
                const ivec3 away = 2 * ivec3(x, y, z) + 1 - middle;
                int distance = 0;  // 1024 on the ellipsoid
                for (int axis = 0; axis < 3; ++axis) {
                    distance += away[axis] * away[axis] * 256 / (shape.crown[axis] * shape.crown[axis]);
                }
                if (distance > 1024 || volume.get({x, y, z}) != Block::air) continue;
                const bool shell = distance > 560;
                if (shell && lattice_pick(seed + static_cast<std::uint32_t>(y), x, z, 1024) < shape.gaps)
                    continue;
                volume.set({x, y, z}, Block::leaves);
            }
        }
    }
}

void generate_tree_small(VoxelVolume& volume, std::uint32_t seed) {
    grow_tree(volume, {-1, 0, -1}, {.trunk = {2, 16, 2}, .crown = {8, 8, 8}, .gaps = 240}, seed);
}

}  // namespace sl
