// SPDX-License-Identifier: MIT
#pragma once

#include "game/voxel/voxel_volume.h"

namespace sl {

/// Fills one column with layers of ground: what the height suggests on top, two blocks of dirt, stone down to
/// `bottom` (inclusive). `height` is the block edge above the top block, 0 on the plain.
void fill_ground_column(VoxelVolume& volume, ivec2 column, int bottom, int height, std::uint32_t seed);

}  // namespace sl
