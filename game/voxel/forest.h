// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "game/voxel/trees.h"

/// Where trees would like to stand: at most one in each square of a grid, thick in forests and rare between them.
namespace sl::forest {

inline constexpr int grid = 6;   ///< blocks
inline constexpr int reach = 6;  ///< no tree reaches farther than this from its foot

struct Seedling {
    ivec2 column;
    std::uint32_t seed;
};
std::optional<Seedling> seedling(std::uint32_t seed, ivec2 square);

/// Conifers stand on high ground, and here and there among the others.
TreeShape shape(const Seedling& seedling, int height);

}  // namespace sl::forest
