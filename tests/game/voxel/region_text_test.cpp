// SPDX-License-Identifier: MIT
#include "game/voxel/region_text.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/core/error.h"
#include "game/voxel/generators.h"

namespace sl {
namespace {

std::string message_of(const std::string& text) {
    VoxelVolume volume;
    volume.set({1, 2, 3}, Block::stone);
    try {
        put_region(volume, text);
    } catch (const Error& error) {
        EXPECT_EQ(volume.block_count(), 1u) << "nothing was set";
        return error.what();
    }
    return "";
}

TEST(RegionText, TellsBlocksInRuns) {
    VoxelVolume volume;
    volume.fill({0, 0, 0}, {2, 1, 2}, Block::grass);
    volume.set({1, 1, 1}, Block::stone);
    EXPECT_EQ(region_text(volume, {0, 0, 0}, {2, 2, 2}), "low 0 0 0 size 2 2 2 kinds grass,air,stone runs 4:0 3:1 1:2");
}

RC_GTEST_PROP(RegionText, IsReadBackAsItWas, ()) {
    VoxelVolume volume, read;
    const ivec3 low(*rc::gen::inRange(-40, 40), *rc::gen::inRange(-40, 40), *rc::gen::inRange(-40, 40));
    const ivec3 size(*rc::gen::inRange(1, 12), *rc::gen::inRange(1, 12), *rc::gen::inRange(1, 12));
    const auto count = *rc::gen::inRange(0, 60);
    for (int i = 0; i < count; ++i) {
        const ivec3 at(*rc::gen::inRange(0, 12), *rc::gen::inRange(0, 12), *rc::gen::inRange(0, 12));
        volume.set(low + at % size, static_cast<Block>(*rc::gen::inRange<std::uint32_t>(0, block_count)));
    }
    put_region(read, region_text(volume, low, low + size));
    RC_ASSERT(read.block_count() == volume.block_count());
    for (int i = 0; i < size.x * size.y * size.z; ++i) {
        const ivec3 cell = low + ivec3(i % size.x, i / size.x % size.y, i / (size.x * size.y));
        RC_ASSERT(read.get(cell) == volume.get(cell));
    }
}

TEST(RegionText, SaysWhatIsWrongAndSetsNothing) {
    EXPECT_EQ(message_of(""), "");
    EXPECT_EQ(message_of("blocks"), "the blocks of a region: at character 1 there should be 'low'");
    EXPECT_EQ(message_of("low 0 0"), "the blocks of a region end where a whole number should follow");
    EXPECT_EQ(message_of("low 0 0 x size"), "the blocks of a region: at character 9 there should be a whole number from -16777216 to 16777216");
    EXPECT_EQ(message_of("low 0 0 0 size 4096 4096 4096 kinds air runs 1:0"), "the blocks of a region: at character 26 there should be fewer blocks: 16777216 at most");
    EXPECT_EQ(message_of("low 0 0 0 size 1 1 1 kinds air,cheese runs 1:0"),
              "the blocks of a region: at character 28 there should be kinds of blocks with commas between them, and 'cheese' is none");
    EXPECT_EQ(message_of("low 0 0 0 size 1 2 1 kinds air runs 3:0"), "the blocks of a region: at character 37 there should be how many blocks are left from 1 to 2");
    EXPECT_EQ(message_of("low 0 0 0 size 1 2 1 kinds air runs 1:1"), "the blocks of a region: at character 37 there should be which of the kinds from 0 to 0");
    EXPECT_EQ(message_of("low 0 0 0 size 1 2 1 kinds air runs 1"), "the blocks of a region: at character 37 there should be a run, for example 12:0");
    EXPECT_EQ(message_of("low 0 0 0 size 1 2 1 kinds stone runs 1:0"), "the blocks of a region end after 1 of 2");
}

TEST(RegionText, ABoxMustHoldSomeBlocksAndNotTooMany) {
    EXPECT_THROW(region_text(VoxelVolume(), {0, 0, 0}, {0, 1, 1}), Error);
    EXPECT_THROW(region_text(VoxelVolume(), {-1000000, 0, -1000000}, {1000000, 1, 1000000}), Error);
    EXPECT_THROW(region_text(VoxelVolume(), {0, 0, 0}, {1 << 30, 1, 1}), Error);
}

}  // namespace
}  // namespace sl
