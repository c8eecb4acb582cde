// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace sl {

// Integers only: floats would let two compilers grow two different worlds from one seed.

/// Hash of a lattice point.
std::uint32_t lattice_hash(std::uint32_t seed, int x, int y);

/// Uniform in [0, bound) at a lattice point; bound > 0.
int lattice_pick(std::uint32_t seed, int x, int y, int bound);

/// Smooth value noise in [0, 1023] with one lattice point every (cell_x, cell_y) units. Repeats after
/// `period` units in both directions where period > 0; it must then be a multiple of both cells.
int value_noise(std::uint32_t seed, int x, int y, int cell_x, int cell_y, int period = 0);

/// Smooth value noise in space, in [0, 1023], along one vertical line: a lattice point every `cell` units on each axis.
/// What lies between two levels of the lattice is computed once, so a whole line costs little more than its levels.
class NoiseLine {
  public:
    /// For y from `low` to `high`, both included.
    NoiseLine(std::uint32_t seed, int x, int z, int low, int high, int cell);
    int at(int y) const;

  private:
    int cell_, first_level_;
    std::vector<int> levels_;
};

}  // namespace sl
