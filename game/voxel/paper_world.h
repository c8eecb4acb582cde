// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "engine/core/math.h"

namespace sl {

/// Blocks with low <= block < high.
struct BlockBox {
    ivec3 low{0};
    ivec3 high{0};
};

}  // namespace sl

/// Where things stand in the world that generate("paper_world") builds, in blocks. y = 0 is the grass'
/// surface: the top layer of ground is y = -1. Nothing here depends on the seed, which only shapes hills and
/// leaves.
namespace sl::paper_world {

inline constexpr float block_size = 0.5f;  ///< metres
inline constexpr int plain_half = 36;  ///< the ground is flat where |x| and |z| of a block's middle are less
inline constexpr int half = 47;        ///< the world is [-half, half) in x and z
inline constexpr int ground_low = -4;  ///< lowest layer, stone
inline constexpr int hill_top = 25;    ///< no hill rises above this edge

/// A log column in the open.
inline constexpr BlockBox pillar{{2, 0, -14}, {4, 10, -12}};

/// Plank house with log corners and a brick roof; the box is its walls from the ground to the eaves. The
/// front, with the door and two windows, looks to -z; one window each to -x and +x.
inline constexpr BlockBox house{{6, 0, 6}, {20, 7, 18}};
inline constexpr BlockBox house_interior{{7, 0, 7}, {19, 7, 17}};
inline constexpr BlockBox house_door{{12, 0, 6}, {14, 4, 7}};
inline constexpr std::array<BlockBox, 4> house_windows{{
    {{8, 2, 6}, {10, 4, 7}},
    {{16, 2, 6}, {18, 4, 7}},
    {{6, 2, 11}, {7, 4, 13}},
    {{19, 2, 11}, {20, 4, 13}},
}};

/// Plank box without windows: light comes in by the door (+x side) and the roof hole only. Its red floor is y
/// = -1.
inline constexpr BlockBox red_house{{-33, 0, -31}, {-17, 9, -15}};
inline constexpr BlockBox red_house_interior{{-32, 0, -30}, {-18, 8, -16}};
inline constexpr BlockBox red_house_floor{{-32, -1, -30}, {-18, 0, -16}};
inline constexpr BlockBox red_house_door{{-18, 0, -20}, {-17, 4, -18}};
inline constexpr BlockBox roof_hole{{-27, 8, -25}, {-24, 9, -22}};

/// Water one block below the grass, sand around and under it.
inline constexpr BlockBox pool_rim{{-32, -1, 8}, {-14, 0, 24}};
inline constexpr BlockBox pool{{-30, -2, 10}, {-16, 0, 22}};  ///< y = -2 is water, y = -1 air above it

/// One of each of the first kinds of block, number 1 (grass) first, every `row_step` blocks along +x.
inline constexpr ivec3 row_start{-22, 0, 30};
inline constexpr int row_step = 2;
inline constexpr std::uint32_t row_kinds = 23;

/// The trees' feet.
inline constexpr std::array<ivec3, 7> trees{{
    {26, 0, -22},
    {31, 0, -6},
    {14, 0, -31},
    {30, 0, 30},
    {-33, 0, 30},
    {-6, 0, -30},
    {-31, 0, -4},
}};

}  // namespace sl::paper_world
