// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "game/voxel/voxel_volume.h"

namespace sl {

/// Cells that a region may have.
inline constexpr std::int64_t most_region_cells = std::int64_t{1} << 24;

/// The blocks with low <= block < high as a line of text, for scene files:
///     low -4 0 2 size 8 3 8 kinds air,grass,stone runs 12:0 3:1 177:2
/// `runs` counts equal blocks along x, then z, then y; a run is how many, and which of the kinds. Throws Error where the box is
/// empty or has more than most_region_cells.
std::string region_text(const VoxelVolume& volume, ivec3 low, ivec3 high);

/// Sets the blocks that a text of region_text tells; nothing for an empty one. Throws Error saying what is wrong in it, and
/// leaves the volume as it was then.
void put_region(VoxelVolume& volume, std::string_view text);

}  // namespace sl
