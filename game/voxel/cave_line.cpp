// SPDX-License-Identifier: MIT
#include "game/voxel/cave_line.h"

#include "game/voxel/landscape.h"

namespace sl {
namespace {

constexpr int cell = 30;
constexpr int radius = 105;  ///< of a tunnel, in noise
constexpr int floor_left = 3;
/// Under water and its shore no cave comes near the surface, or lakes would run out.
constexpr int dry = landscape::sea_level + 4, roof_under_water = 6;

}  // namespace

CaveLine::CaveLine(std::uint32_t seed, int x, int z, int height)
    : first_(seed, x, z, landscape::bottom, height, cell),
      second_(seed + 1, x, z, landscape::bottom, height, cell),
      low_(landscape::bottom + floor_left),
      high_(height < dry ? height - roof_under_water : height) {}

bool CaveLine::open(int y) const {
    if (y < low_ || y >= high_) return false;
    const int a = first_.at(y) - 512, b = second_.at(y) - 512;
    return a * a + b * b < radius * radius;
}

}  // namespace sl
