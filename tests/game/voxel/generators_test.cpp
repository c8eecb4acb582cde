// SPDX-License-Identifier: MIT
#include "game/voxel/generators.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <string>
#include <unordered_set>

#include "engine/core/error.h"
#include "game/voxel/paper_world.h"

namespace sl {
namespace {

namespace world = paper_world;

std::uint64_t checksum(const VoxelVolume& volume) {
    std::uint64_t hash = 0;
    for (const ivec3 key : volume.chunk_keys()) {
        const Chunk* chunk = volume.chunk(key);
        hash = hash_bytes(hash, &key, sizeof key);
        hash = hash_bytes(hash, chunk->blocks.data(), chunk->blocks.size());
    }
    return hash;
}

VoxelVolume generated(std::string_view name, const GeneratorSettings& settings = {}) {
    VoxelVolume volume(world::block_size);
    generate(volume, name, settings);
    return volume;
}

template <class Visit>
void each_cell(const BlockBox& box, Visit&& visit) {
    for (int y = box.low.y; y < box.high.y; ++y) {
        for (int z = box.low.z; z < box.high.z; ++z) {
            for (int x = box.low.x; x < box.high.x; ++x) visit(ivec3(x, y, z));
        }
    }
}

bool contains(const BlockBox& box, ivec3 cell) {
    return glm::all(glm::greaterThanEqual(cell, box.low)) && glm::all(glm::lessThan(cell, box.high));
}

void expect_only(const VoxelVolume& volume, const BlockBox& box, Block kind) {
    int others = 0;
    each_cell(box, [&](ivec3 cell) { others += volume.get(cell) != kind; });
    EXPECT_EQ(others, 0) << block_info(kind).name;
}

/// All air that a walk from `start` reaches inside `limits` without passing `barrier`.
std::unordered_set<ivec3, IvecHash> flood(const VoxelVolume& volume, ivec3 start, const BlockBox& limits,
                                          const std::vector<BlockBox>& barriers) {
    std::unordered_set<ivec3, IvecHash> reached{start};
    std::deque<ivec3> open{start};
    while (!open.empty()) {
        const ivec3 cell = open.front();
        open.pop_front();
        for (int axis = 0; axis < 3; ++axis) {
            for (const int sign : {-1, 1}) {
                ivec3 next = cell;
                next[axis] += sign;
                if (!contains(limits, next) || volume.get(next) != Block::air) continue;
                const auto blocks = [&](const BlockBox& barrier) { return contains(barrier, next); };
                if (std::any_of(barriers.begin(), barriers.end(), blocks)) continue;
                if (reached.insert(next).second) open.push_back(next);
            }
        }
    }
    return reached;
}

std::size_t cell_count(const BlockBox& box) {
    const ivec3 extent = box.high - box.low;
    return static_cast<std::size_t>(extent.x * extent.y * extent.z);
}

TEST(Generators, SameSeedSameBlocks) {
    for (const std::string_view name : generator_names()) {
        EXPECT_EQ(checksum(generated(name)), checksum(generated(name))) << name;
        // Endless land comes where somebody is, and a region holds what its text says.
        const bool empty = name == endless_generator || name == region_generator;
        EXPECT_EQ(generated(name).block_count() == 0, empty) << name;
    }
    EXPECT_NE(checksum(generated("paper_world", {.seed = 1})),
              checksum(generated("paper_world", {.seed = 2})));
}

TEST(Generators, SameBlocksOnEveryMachine) {
    EXPECT_EQ(checksum(generated("paper_world")), 16199179638556721727ull);
    EXPECT_EQ(checksum(generated("tree_small")), 9001089850850229017ull);
}

TEST(Generators, AnUnknownNameListsTheChoices) {
    VoxelVolume volume;
    try {
        generate(volume, "castle");
        FAIL() << "no exception";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("castle"));
        for (const std::string_view name : generator_names()) {
            EXPECT_THAT(error.what(), testing::HasSubstr(std::string(name)));
        }
    }
    EXPECT_THROW(generate(volume, "room", {.size = {0, 3, 3}}), Error);
}

TEST(PaperWorld, IsAsLargeAsTheOriginal) {
    const std::size_t blocks = generated("paper_world").block_count();
    EXPECT_GT(blocks, 50000u);
    EXPECT_LT(blocks, 60000u);
}

TEST(PaperWorld, ThePlainIsFlatGrassOnStone) {
    const VoxelVolume volume = generated("paper_world");
    int wrong = 0;
    for (int z = -world::plain_half; z < world::plain_half; ++z) {
        for (int x = -world::plain_half; x < world::plain_half; ++x) {
            wrong += volume.get({x, world::ground_low, z}) != Block::stone;
            const Block top = volume.get({x, -1, z});
            const bool built = contains(world::pool_rim, {x, -1, z}) ||
                               contains(world::red_house_floor, {x, -1, z}) ||
                               contains({world::house.low - 1, world::house.high}, {x, -1, z});
            wrong += !built && top != Block::grass;
        }
    }
    EXPECT_EQ(wrong, 0);
}

TEST(PaperWorld, HillsCloseTheHorizon) {
    for (const std::uint32_t seed : {1u, 2u, 3u}) {
        const VoxelVolume volume = generated("paper_world", {.seed = seed});
        const auto height = [&](int x, int z) {
            int y = world::hill_top + 1;
            while (y > world::ground_low && volume.get({x, y - 1, z}) == Block::air) --y;
            return y;
        };
        int lowest = world::hill_top;
        for (int i = -world::half; i < world::half; ++i) {
            for (const int rim : {-world::half, world::half - 1}) {
                lowest = std::min({lowest, height(i, rim), height(rim, i)});
                EXPECT_LE(height(i, rim), world::hill_top);
            }
        }
        EXPECT_GE(lowest, 6) << "seed " << seed;
    }
}

TEST(PaperWorld, TheGroundHasNoLeak) {
    const VoxelVolume volume = generated("paper_world");
    const BlockBox hill{{-world::half, world::ground_low - 1, -world::half},
                        {world::half, world::hill_top + 2, world::half}};
    const auto outside = flood(volume, {0, world::hill_top, 0}, hill, {});
    EXPECT_FALSE(outside.contains(hill.low)) << "air below the ground is reached from above it";
}

TEST(PaperWorld, TheRedHouseOpensByDoorAndHoleOnly) {
    const VoxelVolume volume = generated("paper_world");
    const BlockBox limits{world::red_house.low - 8, world::red_house.high + 8};
    const ivec3 inside = world::red_house_interior.low;
    const auto shut = flood(volume, inside, limits, {world::red_house_door, world::roof_hole});
    EXPECT_EQ(shut.size(), cell_count(world::red_house_interior));
    for (const BlockBox& open : {world::red_house_door, world::roof_hole}) {
        expect_only(volume, open, Block::air);
        const BlockBox& other =
            contains(open, world::roof_hole.low) ? world::red_house_door : world::roof_hole;
        EXPECT_GT(flood(volume, inside, limits, {other}).size(), 2 * shut.size());
    }
    expect_only(volume, world::red_house_floor, Block::red_planks);
    EXPECT_EQ(cell_count(world::roof_hole), 9u);
}

TEST(PaperWorld, TheHouseIsOpenAtDoorAndWindows) {
    const VoxelVolume volume = generated("paper_world");
    std::vector<BlockBox> openings(world::house_windows.begin(), world::house_windows.end());
    openings.push_back(world::house_door);
    for (const BlockBox& opening : openings) expect_only(volume, opening, Block::air);
    const BlockBox limits{world::house.low - 8, world::house.high + 16};
    const auto shut = flood(volume, world::house_interior.low, limits, openings);
    EXPECT_GE(shut.size(), cell_count(world::house_interior));
    EXPECT_LT(shut.size(), 2 * cell_count(world::house_interior)) << "the roof holds";
}

TEST(PaperWorld, ThingsStandWhereTheConstantsSay) {
    const VoxelVolume volume = generated("paper_world");
    expect_only(volume, world::pillar, Block::log);
    expect_only(volume, {{world::pool.low.x, -1, world::pool.low.z}, world::pool.high}, Block::air);
    expect_only(volume, {world::pool.low, {world::pool.high.x, -1, world::pool.high.z}}, Block::water);
    for (std::uint32_t number = 1; number <= world::row_kinds; ++number) {
        const ivec3 place = world::row_start + ivec3(world::row_step * (static_cast<int>(number) - 1), 0, 0);
        EXPECT_EQ(volume.get(place), static_cast<Block>(number));
        EXPECT_EQ(volume.get(place + ivec3(0, 1, 0)), Block::air);
    }
    for (const ivec3 foot : world::trees) EXPECT_EQ(volume.get(foot), Block::log);
}

TEST(Props, FitTheirBoxes) {
    const BlockBox creature{{-10, 0, -5}, {10, 16, 5}};
    const BlockBox tree{{-8, 0, -8}, {8, 24, 8}};
    for (const auto& [name, box] : {std::pair{"creature", creature}, std::pair{"tree_small", tree}}) {
        const VoxelVolume volume = generated(name);
        ivec3 low = volume.high();
        ivec3 high = volume.low();
        each_cell({volume.low(), volume.high()}, [&](ivec3 cell) {
            if (volume.get(cell) == Block::air) return;
            low = glm::min(low, cell);
            high = glm::max(high, cell + 1);
        });
        EXPECT_EQ(low, box.low) << name;
        EXPECT_EQ(high, box.high) << name;
    }
}

TEST(Props, TheCreatureIsSymmetric) {
    const VoxelVolume volume = generated("creature");
    each_cell({{-10, 0, 0}, {10, 16, 5}}, [&](ivec3 cell) {
        EXPECT_EQ(volume.get(cell), volume.get({cell.x, cell.y, -1 - cell.z}));
    });
}

TEST(Room, IsClosedOrOpenAsNamed) {
    const ivec3 size(6, 4, 9);
    const BlockBox limits{ivec3(-3), size + 3};
    const std::size_t interior = cell_count({ivec3(0), size});
    EXPECT_EQ(flood(generated("room", {.size = size}), ivec3(0), limits, {}).size(), interior);
    const VoxelVolume skylight = generated("room_skylight", {.size = size});
    EXPECT_GT(flood(skylight, ivec3(0), limits, {}).size(), interior);
    EXPECT_EQ(skylight.get({3, 4, 4}), Block::air);
    const VoxelVolume cornell = generated("room_cornell", {.size = size});
    EXPECT_EQ(cornell.get({-1, 1, 1}), Block::red_wool);
    EXPECT_EQ(cornell.get({6, 1, 1}), Block::green_wool);
    EXPECT_EQ(cornell.get({2, 1, 9}), Block::air);
    EXPECT_EQ(cornell.get({2, 1, -1}), Block::white_wool);
}

}  // namespace
}  // namespace sl
