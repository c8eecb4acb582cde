// SPDX-License-Identifier: MIT
#include "game/streaming/terrain_stream.h"

#include <gtest/gtest.h>

#include <fstream>

#include "game/voxel_content.h"
#include "tests/game/streaming/endless_world.h"

namespace sl {
namespace {

class TerrainStreamTest : public EndlessWorld {};

std::size_t resident_bytes() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages >> pages;
    return pages * 4096;
}

TEST_F(TerrainStreamTest, AllInViewIsThereAtOnceAndNothingBeyond) {
    run();
    EXPECT_EQ(stream().loaded.size(), columns_round(ivec2(0), view_columns).size());
    for (const ivec3 key : volume().chunk_keys()) EXPECT_LE(distance_squared({key.x, key.z}, ivec2(0)), view_columns * view_columns);
    EXPECT_FALSE(content().chunks.empty());
}

TEST_F(TerrainStreamTest, JobThreadsBringTheSameInWhateverOrder) {
    run();
    const std::uint64_t at_once = checksum();
    look_from({3000, 20, 0});
    app_.world.resource<TerrainView>().at_once = false;
    look_from({0, 20, 0});
    EXPECT_LT(stream().loaded.size(), 3u);
    settle();
    EXPECT_EQ(checksum(), at_once);
}

TEST_F(TerrainStreamTest, ColumnsComeFromNearToFar) {
    run();
    app_.world.resource<TerrainView>().at_once = false;
    look_from({3000, 20, 0});
    for (int frame = 0; frame < 20000 && stream().loaded.empty(); ++frame) run();
    for (const ivec2 column : stream().loaded) EXPECT_LE(distance_squared(column, column_of({6000, 0, 0})), view_columns * view_columns);
}

TEST_F(TerrainStreamTest, WhatWasSetIsThereAgainWhenItsColumnComesBack) {
    run();
    const ivec3 cell(5, 60, 0), beside(31, 61, 5);
    set_block(app_.world, terrain_, cell, Block::gold);
    set_block(app_.world, terrain_, beside, Block::brick);
    run();
    const std::uint64_t before = checksum();
    look_from({3000, 20, 0});
    EXPECT_EQ(volume().get(cell), Block::air);
    look_from({0, 20, 0});
    EXPECT_EQ(volume().get(cell), Block::gold);
    EXPECT_EQ(volume().get(beside), Block::brick);
    EXPECT_EQ(checksum(), before);
}

TEST_F(TerrainStreamTest, WhatIsSetFarAwayWaitsForItsColumn) {
    run();
    const ivec3 cell(6000, 70, 0);
    set_block(app_.world, terrain_, cell, Block::gold);
    EXPECT_EQ(volume().get(cell), Block::air);
    look_from({3000, 20, 0});
    EXPECT_EQ(volume().get(cell), Block::gold);
}

TEST_F(TerrainStreamTest, WhatIsSetWhileAJobBuildsTheColumnIsNotLost) {
    run();
    app_.world.resource<TerrainView>().at_once = false;
    look_from({3000, 20, 0});
    const ivec3 cell(6000, 70, 0);
    set_block(app_.world, terrain_, cell, Block::gold);
    settle();
    EXPECT_EQ(volume().get(cell), Block::gold);
}

TEST_F(TerrainStreamTest, ALongFlightLeavesNothingBehind) {
    run();
    std::size_t most_chunks = 0, memory_halfway = 0;
    constexpr int steps = 120;
    for (int step = 0; step < steps; ++step) {
        look_from({16.0 * step, 20, 0});
        const std::size_t chunks = volume().chunk_keys().size();
        most_chunks = std::max(most_chunks, chunks);
        EXPECT_EQ(app_.world.resource<MeshPool>().size(), content().chunks.size() + waters());
        EXPECT_LE(content().chunks.size(), chunks);
        if (step == steps / 2) memory_halfway = resident_bytes();
    }
    constexpr int kept = view_columns + 2;
    EXPECT_LE(stream().loaded.size(), columns_round(ivec2(0), kept).size());
    EXPECT_LE(most_chunks, 5 * columns_round(ivec2(0), kept).size());
    EXPECT_LT(resident_bytes(), memory_halfway + (16u << 20));
}

TEST_F(TerrainStreamTest, AnotherGeneratorTakesTheStreamAway) {
    run();
    app_.world.get<VoxelGenerator>(terrain_).generator = 0;
    run();
    EXPECT_FALSE(app_.world.has<TerrainStream>(terrain_));
    app_.world.destroy(terrain_);
    run();
    EXPECT_EQ(app_.world.resource<VoxelVolumes>().size(), 0u);
    EXPECT_EQ(app_.world.resource<MeshPool>().size(), 0u);
}

}  // namespace
}  // namespace sl
