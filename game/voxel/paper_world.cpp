// SPDX-License-Identifier: MIT
#include "game/voxel/paper_world.h"

#include <algorithm>
#include <cstdlib>

#include "game/voxel/generators.h"
#include "game/voxel/lattice_noise.h"
#include "game/voxel/terrain.h"
#include "game/voxel/trees.h"

namespace sl {
namespace {

using namespace paper_world;

void fill(VoxelVolume& volume, const BlockBox& box, Block kind) {
    volume.fill(box.low, box.high, kind);
}

/// Height of the ground's edge above the plain. Starts beyond a rounded square and climbs outward in
/// terraces.
int ground_height(std::uint32_t seed, int x, int z) {
    const int across = std::abs(2 * x + 1) / 2;
    const int along = std::abs(2 * z + 1) / 2;
    if (std::max(across, along) < plain_half) return 0;
    const int round = std::max(across, along) * 16 + std::max(0, std::min(across, along) - 30) * 6;
    const int foot = (plain_half - 1) * 16 + value_noise(seed, x, z, 10, 10) / 18;
    const int slope = 18 + value_noise(seed + 1, x, z, 14, 14) / 40;
    const int rough = (value_noise(seed + 2, x, z, 4, 4) - 512) / 140;
    const int top = 11 + value_noise(seed + 3, x, z, 18, 18) / 60;
    const int smooth = std::min((round - foot) * slope / 256 + rough, top);
    const int terrace = 1 + value_noise(seed + 4, x, z, 12, 12) / 342;
    return std::clamp((smooth + terrace - 1) / terrace * terrace, 0, hill_top);
}

/// Hills are hollow from below, which nobody sees: the underside follows the ground in tall steps, never
/// closer than four blocks to the lowest surface around, and the outermost columns reach all the way down.
int ground_bottom(std::uint32_t seed, int x, int z) {
    if (x == -half || z == -half || x == half - 1 || z == half - 1) return ground_low;
    int lowest = hill_top;
    for (int dz = -1; dz <= 1; ++dz) {
        for (int dx = -1; dx <= 1; ++dx) lowest = std::min(lowest, ground_height(seed, x + dx, z + dz));
    }
    constexpr int step = 3;
    return ground_low + lowest / step * step;
}

void build_ground(VoxelVolume& volume, std::uint32_t seed) {
    for (int z = -half; z < half; ++z) {
        for (int x = -half; x < half; ++x) {
            const int height = ground_height(seed, x, z);
            fill_ground_column(volume, {x, z}, ground_bottom(seed, x, z), height, seed + 5);
        }
    }
    fill(volume, {pool_rim.low - ivec3(0, 2, 0), pool_rim.high}, Block::sand);
    fill(volume, pool, Block::air);
    fill(volume, {pool.low, {pool.high.x, pool.low.y + 1, pool.high.z}}, Block::water);
}

void build_corners(VoxelVolume& volume, const BlockBox& walls) {
    for (const int x : {walls.low.x, walls.high.x - 1}) {
        for (const int z : {walls.low.z, walls.high.z - 1}) {
            volume.fill({x, walls.low.y, z}, {x + 1, walls.high.y, z + 1}, Block::log);
        }
    }
}

/// A stepped gable roof with its ridge along x, which overhangs by one block.
void build_roof(VoxelVolume& volume, const BlockBox& walls) {
    int y = walls.high.y;
    for (int inset = -1; walls.low.z + inset < walls.high.z - inset; ++inset, ++y) {
        const int low = walls.low.z + inset;
        const int high = walls.high.z - inset;
        for (const int x : {walls.low.x, walls.high.x - 1})
            volume.fill({x, y, low}, {x + 1, y + 1, high}, Block::planks);
        // Two rows per step: each course covers the edge of the one below.
        volume.fill({walls.low.x - 1, y, low}, {walls.high.x + 1, y + 1, std::min(low + 2, high)},
                    Block::brick);
        volume.fill({walls.low.x - 1, y, std::max(high - 2, low)}, {walls.high.x + 1, y + 1, high},
                    Block::brick);
    }
}

void build_houses(VoxelVolume& volume) {
    fill(volume, house, Block::planks);
    fill(volume, house_interior, Block::air);
    volume.fill(house.low - ivec3(0, 1, 0), {house.high.x, 0, house.high.z}, Block::cobblestone);
    volume.fill({house_interior.low.x, -1, house_interior.low.z},
                {house_interior.high.x, 0, house_interior.high.z}, Block::planks);
    build_corners(volume, house);
    build_roof(volume, house);
    fill(volume, house_door, Block::air);
    for (const BlockBox& window : house_windows) fill(volume, window, Block::air);

    fill(volume, red_house, Block::planks);
    fill(volume, red_house_interior, Block::air);
    fill(volume, red_house_floor, Block::red_planks);
    build_corners(volume, red_house);
    fill(volume, red_house_door, Block::air);
    fill(volume, roof_hole, Block::air);
}

}  // namespace

void generate_paper_world(VoxelVolume& volume, std::uint32_t seed) {
    build_ground(volume, seed);
    build_houses(volume);
    fill(volume, pillar, Block::log);
    for (std::uint32_t number = 1; number <= row_kinds; ++number) {
        const ivec3 place = row_start + ivec3(static_cast<int>(number - 1) * row_step, 0, 0);
        volume.set(place, static_cast<Block>(number));
    }
    for (std::uint32_t number = 0; number < trees.size(); ++number) {
        const int taller = lattice_pick(seed + 6, static_cast<int>(number), 0, 3);
        grow_tree(volume, trees[number], {.trunk = {1, 5 + taller, 1}, .crown = {3, 3, 3}},
                  seed + 7 + number);
    }
}

}  // namespace sl
