// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "game/voxel/voxel_volume.h"

namespace sl {

struct VoxelHit {
    Block block = Block::air;
    ivec3 cell{0};          ///< the block that was hit
    ivec3 normal{0};        ///< of the face that was entered; 0 where the ray starts inside the block
    float distance = 0.0f;  ///< metres along the ray
    vec3 position{0.0f};    ///< local metres
};

/// The first block that is not air along a ray, within max_distance metres (infinity is fine). The direction
/// need not be unit. Nothing for a zero or non-finite direction or origin. A ray that only runs along a face
/// counts as inside the cell on the positive side. `free`: another kind that is passed through as air is.
std::optional<VoxelHit> raycast(const VoxelVolume& volume, vec3 origin_local, vec3 direction,
                                float max_distance, Block free = Block::air);

}  // namespace sl
