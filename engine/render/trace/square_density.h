// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/core/math.h"

namespace sl {

/// A point of the unit square and what it counts.
struct WeightedPoint {
    vec2 at;
    float weight;
};

/// A density over the unit square that follows weighted points: a quadtree whose cells are split until few points are
/// left in each (as the directional trees of Müller et al. 2017, "Practical Path Guiding").
class SquareDensity {
  public:
    /// Uniform where there is no point.
    explicit SquareDensity(std::span<const WeightedPoint> points);

    /// Maps uniform xi in [0, 1)² to a point with this density.
    vec2 sample(vec2 xi) const;
    /// Integrates to 1 over the square; 0 outside of it.
    float density(vec2 at) const;

  private:
    struct Cell {
        std::array<float, 4> share{};           ///< of each quarter; bit 0 of its number is the half in x, bit 1 that in y
        std::array<std::uint32_t, 4> inside{};  ///< the cell in each quarter; 0: none, it is uniform
    };
    /// A quarter that is not split.
    struct Leaf {
        vec2 low;
        float size;
        float share;
        double before;  ///< shares of all leaves before it
    };
    std::uint32_t split(std::span<WeightedPoint> points, vec2 low, float size, int depth);
    void list_leaves(std::uint32_t cell, vec2 low, float size, double share);

    std::vector<Cell> cells_;  ///< the first is the whole square
    std::vector<Leaf> leaves_;
    std::vector<std::uint32_t> first_leaf_;  ///< for each of as many equal parts of the interval: the leaf at its start
};

}  // namespace sl
