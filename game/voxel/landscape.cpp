// SPDX-License-Identifier: MIT
#include "game/voxel/landscape.h"

#include <algorithm>
#include <cstdlib>

#include "game/voxel/lattice_noise.h"

namespace sl::landscape {
namespace {

constexpr int middle = 512;  ///< of value_noise
constexpr int snow_line = 50;
constexpr int shore = sea_level + 2;

int centred(std::uint32_t seed, ivec2 column, int cell, int amplitude) {
    return (value_noise(seed, column.x, column.y, cell, cell) - middle) * amplitude / middle;
}

/// Ridges where the mountain noise is high, nothing elsewhere.
int mountains(std::uint32_t seed, ivec2 column) {
    const int rise = std::max(0, value_noise(seed, column.x, column.y, 170, 170) - 560);
    if (rise == 0) return 0;
    const int ridge = middle - std::abs(value_noise(seed + 1, column.x, column.y, 67, 67) - middle);
    return rise * (ridge + 220) / 3600;
}

}  // namespace

int height(std::uint32_t seed, ivec2 column) {
    const int hills = centred(seed, column, 230, 38) + centred(seed + 1, column, 89, 20) + centred(seed + 2, column, 37, 6);
    return std::clamp(9 + hills + mountains(seed + 4, column), bottom + 8, highest);
}

Ground ground(std::uint32_t seed, ivec2 column, int height, int steepness) {
    const int patch = value_noise(seed + 10, column.x, column.y, 9, 9);
    if (height <= shore) return {.top = Block::sand, .below = Block::sand};
    if (height + (patch - middle) / 64 >= snow_line) return {.top = Block::snow, .below = Block::stone};
    // Soil does not hold on a cliff.
    if (steepness >= 3) return {.top = patch > 700 ? Block::cobblestone : Block::stone, .below = Block::stone};
    if (steepness == 2 && patch > 760) return {.top = Block::dirt};
    return {};
}

}  // namespace sl::landscape
