// SPDX-License-Identifier: MIT
#include "game/block_tool.h"

#include <gtest/gtest.h>

#include "engine/core/input.h"
#include "engine/ecs/components.h"
#include "game/notice.h"
#include "game/voxel_content.h"

namespace sl {
namespace {

/// A camera in a room of blocks of 0.5 m, looking along -z at a wall of stone in cells z = -4.
class BlockToolTest : public testing::Test {
  protected:
    App app_;
    Entity blocks_;
    Entity camera_;
    static constexpr ivec3 target{0, 0, -4};

    BlockToolTest() {
        add_voxel_world(app_);
        add_block_tool(app_);
        VoxelVolume volume(0.5f);
        volume.fill({-4, -4, -4}, {5, 5, -3}, Block::stone);
        const auto handle = app_.world.resource<VoxelVolumes>().insert(std::move(volume));
        // The generator is what was made, so that the system keeps the blocks above.
        blocks_ = app_.world.create(VoxelGenerator{},
                                    VoxelContent{.volume = handle, .made_by = {}, .chunks = {}}, Transform{});
        camera_ = app_.world.create(Camera{}, Transform{.translation = {0.25, 0.25, 0.25}});
        app_.schedule.run(app_.world);
        app_.world.resource<Input>().mouse_captured = true;
    }
    Block at(ivec3 cell) {
        return app_.world.resource<VoxelVolumes>().at(app_.world.get<VoxelContent>(blocks_).volume).get(cell);
    }
    void click(MouseButton button) {
        auto& input = app_.world.resource<Input>();
        input.buttons_pressed.set(static_cast<std::size_t>(button));
        app_.schedule.run(app_.world);
        input.buttons_pressed.reset();
    }
    void press(Key key) {
        auto& input = app_.world.resource<Input>();
        input.keys_pressed.set(static_cast<std::size_t>(key));
        app_.schedule.run(app_.world);
        input.keys_pressed.reset();
    }
    void stand_at(dvec3 place) {
        app_.world.get<Transform>(camera_).translation = place;
        app_.schedule.run(app_.world);
    }
};

TEST_F(BlockToolTest, LeftBreaksAndTheChunkIsMeshedInTheSameFrame) {
    ASSERT_EQ(at(target), Block::stone);
    click(MouseButton::left);
    EXPECT_EQ(at(target), Block::air);
    EXPECT_GT(app_.world.resource<VoxelStats>().remeshed, 0u);
}

TEST_F(BlockToolTest, RightPlacesTheChosenKindOnTheFace) {
    press(Key::digit_8);
    EXPECT_EQ(app_.world.resource<BlockTool>().held, block_palette[7]);
    EXPECT_EQ(app_.world.resource<Notice>().text, block_info(block_palette[7]).name);
    click(MouseButton::right);
    EXPECT_EQ(at({0, 0, -3}), block_palette[7]);
    EXPECT_EQ(at(target), Block::stone);
}

TEST_F(BlockToolTest, NothingIsPlacedWhereTheCameraIs) {
    stand_at({0.25, 0.25, -1.2});
    click(MouseButton::right);
    EXPECT_EQ(at({0, 0, -3}), Block::air);
}

TEST_F(BlockToolTest, InsideABlockItBreaksThatOneAndPlacesNothing) {
    stand_at({0.25, 0.25, -1.75});
    click(MouseButton::right);
    EXPECT_EQ(at({0, 0, -5}), Block::air);
    click(MouseButton::left);
    EXPECT_EQ(at(target), Block::air);
}

TEST_F(BlockToolTest, ReachesEightMetres) {
    stand_at({0.25, 0.25, 6.6});
    click(MouseButton::left);
    EXPECT_EQ(at(target), Block::stone);
    stand_at({0.25, 0.25, 6.3});
    click(MouseButton::left);
    EXPECT_EQ(at(target), Block::air);
}

TEST_F(BlockToolTest, MiddleTakesTheKindThatIsSeen) {
    click(MouseButton::middle);
    EXPECT_EQ(app_.world.resource<BlockTool>().held, Block::stone);
}

TEST_F(BlockToolTest, WithoutTheMouseCapturedAClickDoesNothing) {
    app_.world.resource<Input>().mouse_captured = false;
    click(MouseButton::left);
    EXPECT_EQ(at(target), Block::stone);
}

TEST_F(BlockToolTest, WithoutACameraOrBlocksNothingHappens) {
    app_.world.destroy(camera_);
    click(MouseButton::left);
    EXPECT_EQ(at(target), Block::stone);
    camera_ = app_.world.create(Camera{}, Transform{.rotation = glm::angleAxis(pi, vec3(0, 1, 0))});
    app_.schedule.run(app_.world);
    click(MouseButton::left);
    click(MouseButton::right);
    EXPECT_EQ(at(target), Block::stone);
}

}  // namespace
}  // namespace sl
