// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/math.h"
#include "game/voxel/blocks.h"

/// The shape of land that nobody built on: hills, mountains and lakes without end. All of it is a function of seed and
/// position in whole numbers. A height is the block edge above the top block; 0 is the plain.
namespace sl::landscape {

inline constexpr int bottom = -32;     ///< lowest layer
inline constexpr int sea_level = -4;   ///< edge above the water
inline constexpr int highest = 96;     ///< no ground rises above this edge

int height(std::uint32_t seed, ivec2 column);

/// What a column of ground is made of.
struct Ground {
    Block top = Block::grass, below = Block::dirt;
    int depth = 3;  ///< of `below`; then comes stone
};
/// `steepness` is by how many blocks the highest of the four columns beside it differs.
Ground ground(std::uint32_t seed, ivec2 column, int height, int steepness);

}  // namespace sl::landscape
