// SPDX-License-Identifier: MIT
#include "game/voxel/crystal_valley.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "game/voxel/generators.h"
#include "game/voxel/lattice_noise.h"
#include "game/voxel/terrain.h"
#include "game/voxel/trees.h"

namespace sl {
namespace {

using namespace crystal_valley;

/// The meadow's rim rises in rough steps, so that the valley closes.
int ground_height(std::uint32_t seed, int x, int z) {
    const int out = std::max(std::abs(2 * x + 1), std::abs(2 * z + 1)) / 2 - meadow_half;
    if (out < 0) return 0;
    return std::clamp(1 + out / 2 + (value_noise(seed, x, z, 14, 14) - 300) / 90, 0, 14);
}

void build_ground(VoxelVolume& volume, std::uint32_t seed) {
    for (int z = -half; z < half; ++z) {
        for (int x = -half; x < half; ++x) fill_ground_column(volume, {x, z}, ground_low, ground_height(seed, x, z), seed + 2);
    }
}

/// A box of blocks with walls one thick around `low` to `high`, which are air.
void build_hall(VoxelVolume& volume, ivec3 low, ivec3 high, Block walls) {
    volume.fill(low - 1, high + 1, walls);
    volume.fill(low, high, Block::air);
}

/// Steps that one walks up, two wide: each a block higher and a block on, from `foot` (air above it) along `along`.
void dig_stairs(VoxelVolume& volume, ivec3 foot, ivec3 along, int steps) {
    const ivec3 across = ivec3(std::abs(along.z), 0, std::abs(along.x));
    for (int step = 0; step < steps; ++step) {
        const ivec3 at = foot + step * (along + ivec3(0, 1, 0));
        volume.fill(at, at + ivec3(1, 5, 1) + across, Block::air);
        volume.fill(at - ivec3(0, 1, 0), at + ivec3(1, 0, 1) + across, Block::cobblestone);
    }
}

/// A mound with a tunnel that turns once: whoever stands before it sees no crystal, and no light from there gets round
/// the corner but by the walls.
void build_dawn(VoxelVolume& volume) {
    volume.fill({-5, 0, -32}, {9, 6, -15}, Block::stone);
    volume.fill({-3, 6, -30}, {7, 7, -18}, Block::grass);
    volume.fill({-5, -1, -32}, {9, 0, -15}, Block::cobblestone);
    volume.fill({-2, 0, -28}, {2, 4, -15}, Block::air);
    volume.fill({2, 0, -28}, {6, 4, -25}, Block::air);
}

/// White inside, so that whatever is put where the sun falls colours the whole hall.
void build_ember(VoxelVolume& volume) {
    build_hall(volume, {16, 0, -29}, {28, 7, -17}, Block::white_wool);
    volume.fill({15, 0, -24}, {16, 4, -22}, Block::air);
    volume.fill({20, 7, -25}, {23, 8, -23}, Block::air);
}

/// All orange, round a yellow lamp: neither of them gives any blue.
void build_deep(VoxelVolume& volume) {
    build_hall(volume, {19, -10, 19}, {28, -5, 28}, Block::orange_wool);
    volume.set({23, -5, 23}, Block::glowstone);
    dig_stairs(volume, {18, -10, 22}, {-1, 0, 0}, 11);
}

/// Green at its foot and stone above, under a lid.
void build_moss(VoxelVolume& volume) {
    volume.fill({-28, -11, 13}, {-22, 2, 19}, Block::cobblestone);
    volume.fill({-28, -11, 13}, {-18, -6, 19}, Block::green_wool);
    volume.fill({-27, -10, 14}, {-23, 2, 18}, Block::air);
    volume.fill({-27, 1, 14}, {-23, 2, 18}, Block::planks);
    volume.fill({-23, -10, 14}, {-19, -7, 18}, Block::air);
    dig_stairs(volume, {-19, -10, 15}, {1, 0, 0}, 11);
}

/// A sunlit white hall, and behind it a room that gets light from there alone.
void build_dusk(VoxelVolume& volume) {
    build_hall(volume, {-31, 0, -30}, {-20, 7, -18}, Block::white_wool);
    build_hall(volume, {-40, 0, -30}, {-32, 6, -20}, Block::white_wool);
    volume.fill({-32, 0, -26}, {-31, 4, -24}, Block::air);
    volume.fill({-26, 0, -18}, {-24, 4, -17}, Block::air);
    volume.fill({-27, 7, -26}, {-24, 8, -24}, Block::air);
}

constexpr std::array<ivec3, 8> trees{{{-14, 0, -8}, {12, 0, 8}, {-10, 0, 26}, {34, 0, -6}, {-36, 0, 6}, {6, 0, 36}, {36, 0, 34}, {-36, 0, 34}}};

}  // namespace

void generate_crystal_valley(VoxelVolume& volume, std::uint32_t seed) {
    build_ground(volume, seed);
    // Paths of sand lead from the middle to all five doors.
    volume.fill({-2, -1, -15}, {2, 0, 12}, Block::sand);
    volume.fill({-25, -1, -13}, {15, 0, -11}, Block::sand);
    volume.fill({13, -1, -24}, {15, 0, -11}, Block::sand);
    volume.fill({-26, -1, -17}, {-24, 0, -11}, Block::sand);
    volume.fill({-8, -1, 15}, {8, 0, 17}, Block::sand);
    volume.fill({6, -1, 15}, {8, 0, 24}, Block::sand);
    build_dawn(volume);
    build_ember(volume);
    build_deep(volume);
    build_moss(volume);
    build_dusk(volume);
    for (std::uint32_t number = 0; number < trees.size(); ++number) {
        const int taller = lattice_pick(seed + 3, static_cast<int>(number), 0, 3);
        grow_tree(volume, trees[number], {.trunk = {1, 5 + taller, 1}, .crown = {3, 3, 3}}, seed + 4 + number);
    }
}

}  // namespace sl
