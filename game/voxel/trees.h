// SPDX-License-Identifier: MIT
#pragma once

#include "game/voxel/voxel_volume.h"

namespace sl {

struct TreeShape {
    ivec3 trunk{1, 5, 1};  ///< width, height up to the crown's middle, depth; blocks
    ivec3 crown{3, 3, 3};  ///< half axes of the ellipsoid of leaves, blocks
    int gaps = 180;        ///< share of the crown's outer shell that is left out, of 1024
};

/// Grows a tree whose trunk's low corner is `foot`. Leaves fill air only.
void grow_tree(VoxelVolume& volume, ivec3 foot, const TreeShape& shape, std::uint32_t seed);

}  // namespace sl
