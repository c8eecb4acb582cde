// SPDX-License-Identifier: MIT
#pragma once

#include "game/voxel/lattice_noise.h"

namespace sl {

/// Where caves cut one vertical line of ground. A cave is a tunnel along the curve on which two noises are at their middle, so
/// it branches, goes up and down, and now and then opens in a hillside.
class CaveLine {
  public:
    /// For ground from landscape::bottom up to `height`.
    CaveLine(std::uint32_t seed, int x, int z, int height);
    /// Whether block y is carved out.
    bool open(int y) const;

  private:
    NoiseLine first_, second_;
    int low_, high_;
};

}  // namespace sl
