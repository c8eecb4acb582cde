// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "game/voxel/voxel_volume.h"

namespace sl {

/// Something built once, a square of land with all that stands on it, which lies at a fixed place of an endless terrain.
class BuiltPlace {
  public:
    /// `blocks` fill [-half, half) in x and z; they come to lie round `middle`.
    BuiltPlace(VoxelVolume blocks, ivec2 middle, int half);

    bool contains(ivec2 column) const { return distance(column) == 0; }
    /// Roughly how many blocks away its edge is; 0 inside.
    int distance(ivec2 column) const;
    /// Height of the place's ground where it is nearest to a column.
    int rim_height(ivec2 column) const;
    /// Copies its blocks of a column that it contains: `volume` is stone below them and as before above.
    void fill_column(VoxelVolume& volume, ivec2 column) const;

  private:
    VoxelVolume blocks_;
    ivec2 middle_;
    int half_, low_, high_;
};

}  // namespace sl
