// SPDX-License-Identifier: MIT
#include "game/voxel/endless_terrain.h"

#include <gtest/gtest.h>

#include <array>

#include "game/voxel/crystal_valley.h"
#include "game/voxel/generators.h"
#include "game/voxel/landscape.h"
#include "game/voxel/paper_world.h"

namespace sl {
namespace {

VoxelVolume filled(const EndlessTerrain& terrain, ivec2 low, ivec2 high) {
    VoxelVolume volume;
    terrain.fill(volume, low, high);
    return volume;
}

template <class Visit>
void each_cell(ivec2 low, ivec2 high, Visit&& visit) {
    for (int y = landscape::bottom; y < landscape::highest + 20; ++y) {
        for (int z = low.y; z < high.y; ++z) {
            for (int x = low.x; x < high.x; ++x) visit(ivec3(x, y, z));
        }
    }
}

TEST(EndlessTerrain, ABlockDependsOnItsPositionAlone) {
    const EndlessTerrain terrain(3);
    // Far from any place, at the edge of one, and between forests.
    for (const ivec2 low : {ivec2(1000, -2000), ivec2(40, 40), ivec2(-400, 90)}) {
        const VoxelVolume small = filled(terrain, low, low + 20), large = filled(EndlessTerrain(3), low - 33, low + 51);
        int different = 0;
        each_cell(low, low + 20, [&](ivec3 cell) { different += small.get(cell) != large.get(cell); });
        EXPECT_EQ(different, 0);
    }
}

TEST(EndlessTerrain, AnotherSeedIsAnotherWorld) {
    const ivec2 low(1000, 1000);
    const VoxelVolume one = filled(EndlessTerrain(1), low, low + 32), other = filled(EndlessTerrain(2), low, low + 32);
    int different = 0;
    each_cell(low, low + 32, [&](ivec3 cell) { different += one.get(cell) != other.get(cell); });
    EXPECT_GT(different, 1000);
}

void expect_place(const EndlessTerrain& terrain, const VoxelVolume& blocks, ivec2 middle, int half) {
    const VoxelVolume land = filled(terrain, middle - half, middle + half);
    int different = 0;
    each_cell(ivec2(-half), ivec2(half), [&](ivec3 cell) {
        const Block wanted = blocks.get(cell), found = land.get(cell + ivec3(middle.x, 0, middle.y));
        // Below what was built lies stone.
        different += found != wanted && !(wanted == Block::air && found == Block::stone);
    });
    EXPECT_EQ(different, 0);
}

TEST(EndlessTerrain, TheBuiltPlacesStandInIt) {
    const EndlessTerrain terrain(1);
    VoxelVolume valley, village;
    generate_crystal_valley(valley, 1);
    generate_paper_world(village, 1);
    expect_place(terrain, valley, ivec2(0), crystal_valley::half);
    expect_place(terrain, village, EndlessTerrain::village, paper_world::half);
}

TEST(EndlessTerrain, NoCliffStandsRoundAPlace) {
    const EndlessTerrain terrain(1);
    for (int along = -60; along < 60; ++along) {
        for (int out = 50; out < 120; ++out) {
            EXPECT_LE(std::abs(terrain.height({-out, along}) - terrain.height({-out - 1, along})), 6) << out << " " << along;
        }
    }
}

TEST(EndlessTerrain, HasHillsLakesCavesForestsAndSnow) {
    const EndlessTerrain terrain(1);
    std::array<std::size_t, block_count> found{};
    std::size_t caves = 0;
    for (int number = 0; number < 64; ++number) {
        const ivec2 low((number % 8 - 4) * 150 + 20, (number / 8 - 4) * 150 + 20);
        const VoxelVolume land = filled(terrain, low, low + 16);
        each_cell(low, low + 16, [&](ivec3 cell) {
            const Block block = land.get(cell);
            ++found[static_cast<std::size_t>(block)];
            caves += block == Block::air && cell.y < terrain.height({cell.x, cell.z});
        });
    }
    for (const Block kind : {Block::grass, Block::sand, Block::water, Block::log, Block::leaves, Block::stone, Block::snow}) {
        EXPECT_GT(found[static_cast<std::size_t>(kind)], 50u) << block_info(kind).name;
    }
    EXPECT_GT(caves, 5000u);
}

}  // namespace
}  // namespace sl
