// SPDX-License-Identifier: MIT
#pragma once

#include "game/voxel/built_place.h"

namespace sl {

/// Land without end: hills, caves, lakes and forests, with the crystal valley at the origin and the paper's village east of
/// it. Immutable, so that any number of threads may read it, and each block depends on nothing but seed and position.
class EndlessTerrain {
  public:
    static constexpr ivec2 village{200, 0};  ///< middle of the village, blocks

    explicit EndlessTerrain(std::uint32_t seed);

    /// Height of the ground's edge; inside a place, of the ground at its rim.
    int height(ivec2 column) const;
    /// Fills all columns with low <= column < high, from air. Trees may stand out of them.
    void fill(VoxelVolume& volume, ivec2 low, ivec2 high) const;
    const std::vector<BuiltPlace>& places() const { return places_; }

  private:
    /// The place whose rim is nearest; places lie far from each other.
    const BuiltPlace& nearest_place(ivec2 column) const;
    void fill_column(VoxelVolume& volume, ivec2 column) const;
    void fill_ground(VoxelVolume& volume, ivec2 column) const;
    void grow_trees(VoxelVolume& volume, ivec2 low, ivec2 high) const;
    bool carries_tree(ivec2 column, int height) const;
    int steepness(ivec2 column, int height) const;

    std::uint32_t seed_;
    std::vector<BuiltPlace> places_;
};

}  // namespace sl
