// SPDX-License-Identifier: MIT
#include "game/voxel/lattice_noise.h"

#include "engine/core/math.h"

namespace sl {
namespace {

constexpr int one = 1024;

int floor_div(int value, int divisor) {
    return value >= 0 ? value / divisor : -((-value + divisor - 1) / divisor);
}

int wrap(int value, int period) {
    return period > 0 ? value - floor_div(value, period) * period : value;
}

int smoothstep(int t) {
    return t * t / one * (3 * one - 2 * t) / one;
}

}  // namespace

std::uint32_t lattice_hash(std::uint32_t seed, int x, int y) {
    const std::uint64_t point =
        (std::uint64_t{static_cast<std::uint32_t>(x)} << 32) | static_cast<std::uint32_t>(y);
    return static_cast<std::uint32_t>(hash_mix(hash_mix(0, seed), point) >> 32);
}

int lattice_pick(std::uint32_t seed, int x, int y, int bound) {
    return static_cast<int>((std::uint64_t{lattice_hash(seed, x, y)} * static_cast<std::uint32_t>(bound)) >>
                            32);
}

int value_noise(std::uint32_t seed, int x, int y, int cell_x, int cell_y, int period) {
    const int column = floor_div(x, cell_x);
    const int row = floor_div(y, cell_y);
    const int across = smoothstep((x - column * cell_x) * one / cell_x);
    const int up = smoothstep((y - row * cell_y) * one / cell_y);
    const auto corner = [&](int right, int above) {
        return lattice_pick(seed, wrap(column + right, period / cell_x), wrap(row + above, period / cell_y),
                            one);
    };
    const int below = corner(0, 0) * (one - across) + corner(1, 0) * across;
    const int above = corner(0, 1) * (one - across) + corner(1, 1) * across;
    return (below / one * (one - up) + above / one * up) / one;
}

NoiseLine::NoiseLine(std::uint32_t seed, int x, int z, int low, int high, int cell)
    : cell_(cell), first_level_(floor_div(low, cell)) {
    for (int level = first_level_; level <= floor_div(high, cell) + 1; ++level) {
        levels_.push_back(value_noise(lattice_hash(seed, level, 0), x, z, cell, cell));
    }
}

int NoiseLine::at(int y) const {
    const int level = floor_div(y, cell_);
    const int up = smoothstep((y - level * cell_) * one / cell_);
    const auto below = static_cast<std::size_t>(level - first_level_);
    return (levels_[below] * (one - up) + levels_[below + 1] * up) / one;
}

}  // namespace sl
