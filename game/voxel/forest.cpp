// SPDX-License-Identifier: MIT
#include "game/voxel/forest.h"

#include "game/voxel/lattice_noise.h"

namespace sl::forest {
namespace {

constexpr int forest_from = 540;  ///< of the noise that says where forests are
constexpr int thick = 780, sparse = 45;  ///< of 1024 squares with a tree, in a forest and outside

}  // namespace

std::optional<Seedling> seedling(std::uint32_t seed, ivec2 square) {
    const auto pick = [&](std::uint32_t number, int bound) { return lattice_pick(seed + number, square.x, square.y, bound); };
    const ivec2 column = square * grid + ivec2(pick(0, grid - 1), pick(1, grid - 1));
    const int wood = value_noise(seed + 2, column.x, column.y, 75, 75);
    if (pick(3, 1024) >= (wood > forest_from ? thick : sparse)) return std::nullopt;
    return Seedling{column, lattice_hash(seed + 4, square.x, square.y)};
}

TreeShape shape(const Seedling& seedling, int height) {
    const auto pick = [&](std::uint32_t number, int bound) { return lattice_pick(seedling.seed + number, 0, 0, bound); };
    if (height + pick(0, 40) > 44) {
        const int half = 5 + pick(1, 3);
        return {.trunk = {1, half + 2 + pick(2, 2), 1}, .crown = {2, half, 2}, .gaps = 220};
    }
    const int wide = 3 + pick(1, 2);
    return {.trunk = {1, 5 + pick(2, 4), 1}, .crown = {wide, 3, 3 + pick(3, 2)}};
}

}  // namespace sl::forest
