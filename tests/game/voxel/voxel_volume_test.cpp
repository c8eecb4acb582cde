// SPDX-License-Identifier: MIT
#include "game/voxel/voxel_volume.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sl {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(VoxelVolume, StartsAsAir) {
    VoxelVolume volume(0.5f);
    EXPECT_EQ(volume.get({1, -2, 3}), Block::air);
    EXPECT_EQ(volume.block_count(), 0u);
    EXPECT_EQ(volume.low(), volume.high());
    EXPECT_EQ(volume.chunk({0, 0, 0}), nullptr);
    EXPECT_THAT(volume.take_changed_chunks(), IsEmpty());
    EXPECT_FLOAT_EQ(volume.block_size(), 0.5f);
}

TEST(VoxelVolume, NegativeCoordinatesRoundDown) {
    EXPECT_EQ(chunk_key_of({-1, -32, -33}), ivec3(-1, -1, -2));
    EXPECT_EQ(chunk_key_of({0, 31, 32}), ivec3(0, 0, 1));
    EXPECT_EQ(local_in_chunk({-1, -32, -33}), ivec3(31, 0, 31));
    VoxelVolume volume;
    volume.set({-1, -32, -33}, Block::stone);
    EXPECT_EQ(volume.get({-1, -32, -33}), Block::stone);
    EXPECT_EQ(volume.get({0, -32, -33}), Block::air);
    EXPECT_EQ(volume.get({31, 0, 31}), Block::air);
    EXPECT_EQ(volume.low(), ivec3(-32, -32, -64));
    EXPECT_EQ(volume.high(), ivec3(0, 0, -32));
}

TEST(VoxelVolume, AWriteMarksItsChunkOnce) {
    VoxelVolume volume;
    volume.set({5, 5, 5}, Block::dirt);
    volume.set({6, 5, 5}, Block::dirt);
    EXPECT_THAT(volume.take_changed_chunks(), ElementsAre(ivec3(0)));
    EXPECT_EQ(volume.changed_box(ivec3(0)).low, ivec3(5, 5, 5));
    EXPECT_EQ(volume.changed_box(ivec3(0)).high, ivec3(7, 6, 6));
    volume.set({6, 5, 5}, Block::dirt);
    EXPECT_THAT(volume.take_changed_chunks(), IsEmpty()) << "the same block again changes nothing";
    EXPECT_EQ(volume.changed_box(ivec3(0)).low, volume.changed_box(ivec3(0)).high);
}

TEST(VoxelVolume, AWriteAtABorderMarksTheTouchingChunkThatExists) {
    VoxelVolume volume;
    volume.set({-5, 5, 5}, Block::dirt);
    volume.set({5, 5, 40}, Block::dirt);
    volume.take_changed_chunks();
    volume.set({0, 5, 5}, Block::stone);
    EXPECT_THAT(volume.take_changed_chunks(), ElementsAre(ivec3(-1, 0, 0), ivec3(0)));
    volume.set({5, 5, 31}, Block::stone);
    EXPECT_THAT(volume.take_changed_chunks(), ElementsAre(ivec3(0), ivec3(0, 0, 1)));
    volume.set({5, 5, 30}, Block::stone);
    EXPECT_THAT(volume.take_changed_chunks(), ElementsAre(ivec3(0)));
}

TEST(VoxelVolume, AnEmptiedChunkGoesAndIsReported) {
    VoxelVolume volume;
    volume.set({40, 0, 0}, Block::dirt);
    volume.take_changed_chunks();
    volume.set({40, 0, 0}, Block::air);
    EXPECT_EQ(volume.chunk({1, 0, 0}), nullptr);
    EXPECT_EQ(volume.block_count(), 0u);
    EXPECT_THAT(volume.take_changed_chunks(), ElementsAre(ivec3(1, 0, 0)));
}

TEST(VoxelVolume, FillCrossesChunks) {
    VoxelVolume volume;
    volume.fill({-3, 30, -1}, {4, 34, 2}, Block::sand);
    EXPECT_EQ(volume.block_count(), 7u * 4u * 3u);
    EXPECT_EQ(volume.chunk_keys().size(), 8u);
    EXPECT_EQ(volume.get({-3, 30, -1}), Block::sand);
    EXPECT_EQ(volume.get({3, 33, 1}), Block::sand);
    EXPECT_EQ(volume.get({4, 33, 1}), Block::air);
    volume.fill({-3, 30, -1}, {4, 34, 2}, Block::air);
    EXPECT_EQ(volume.block_count(), 0u);
    EXPECT_THAT(volume.chunk_keys(), IsEmpty());
}

TEST(VoxelVolume, AnEmptyBoxFillsNothing) {
    VoxelVolume volume;
    volume.fill({3, 0, 0}, {3, 9, 9}, Block::sand);
    volume.fill({3, 0, 0}, {1, 9, 9}, Block::sand);
    EXPECT_EQ(volume.block_count(), 0u);
    EXPECT_THAT(volume.take_changed_chunks(), IsEmpty());
}

TEST(VoxelVolume, ACopyStandsAlone) {
    VoxelVolume volume;
    volume.set({1, 1, 1}, Block::iron);
    VoxelVolume copy = volume;
    copy.set({1, 1, 1}, Block::gold);
    EXPECT_EQ(volume.get({1, 1, 1}), Block::iron);
}

}  // namespace
}  // namespace sl
