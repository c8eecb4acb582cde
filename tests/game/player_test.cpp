// SPDX-License-Identifier: MIT
#include "game/player/player.h"

#include <gtest/gtest.h>

#include "engine/core/clock.h"
#include "engine/core/input.h"
#include "engine/ecs/components.h"
#include "game/block_tool.h"
#include "game/flashlight.h"
#include "game/fly_camera.h"
#include "game/voxel_content.h"

namespace sl {
namespace {

/// A floor of blocks of 0.5 m with its top at y = 0, and a camera two metres over it.
class PlayerTest : public testing::Test {
  protected:
    App app_;
    Entity blocks_, camera_;

    PlayerTest() {
        add_voxel_world(app_);
        app_.world.add_resource(FrameClock{});
        add_block_tool(app_);
        add_fly_camera(app_);
        add_player(app_);
        add_flashlight(app_);
        VoxelVolume volume(0.5f);
        volume.fill({-40, -2, -40}, {40, 0, 40}, Block::stone);
        const auto handle = app_.world.resource<VoxelVolumes>().insert(std::move(volume));
        blocks_ = app_.world.create(VoxelGenerator{}, VoxelContent{.volume = handle, .made_by = {}, .chunks = {}}, Transform{});
        camera_ = app_.world.create(Camera{}, Transform{.translation = {0.25, 2.0, 0.25}});
    }
    dvec3& eyes() { return app_.world.get<Transform>(camera_).translation; }
    Player& player() { return app_.world.resource<Player>(); }
    Input& input() { return app_.world.resource<Input>(); }
    void hold(Key key) { input().keys_down.set(static_cast<std::size_t>(key)); }
    void press(Key key) {
        input().keys_pressed.set(static_cast<std::size_t>(key));
        run(1);
        input().keys_pressed.reset();
    }
    void run(int frames, double step = 1.0 / 60.0) {
        app_.world.resource<FrameClock>().step = step;
        for (int i = 0; i < frames; ++i) app_.schedule.run(app_.world);
    }
};

TEST_F(PlayerTest, BeginsOnFootOverGroundAndStands) {
    run(120);
    EXPECT_FALSE(player().flying);
    EXPECT_NEAR(eyes().y, 1.65, 1e-2);
}

TEST_F(PlayerTest, BeginsInFlightHighUp) {
    eyes().y = 30.0;
    run(60);
    EXPECT_TRUE(player().flying);
    EXPECT_EQ(eyes().y, 30.0);
    press(Key::v);
    run(300);
    EXPECT_NEAR(eyes().y, 1.65, 1e-2) << "down on its feet";
    press(Key::v);
    hold(Key::e);
    run(60);
    EXPECT_GT(eyes().y, 3.0) << "and up again";
}

TEST_F(PlayerTest, WalksAsFarAtAnyFrameRate) {
    run(60);
    hold(Key::w);
    std::vector<double> ways;
    for (const int rate : {15, 60, 144}) {
        eyes() = {0.25, 1.65, 0.25};
        run(rate, 1.0 / rate);
        ways.push_back(eyes().z);
    }
    EXPECT_NEAR(ways[0], ways[1], 0.08);
    EXPECT_NEAR(ways[2], ways[1], 0.08);
}

TEST_F(PlayerTest, MovesALittleInEachOfManyFrames) {
    run(60);
    hold(Key::w);
    run(60);
    // 500 frames a second, four to a step of the simulation: the camera is in between.
    for (int i = 0; i < 20; ++i) {
        const double before = eyes().z;
        run(1, 0.002);
        EXPECT_NEAR(before - eyes().z, 4.3 * 0.002, 1e-3);
    }
}

TEST_F(PlayerTest, GoesWhereItIsPut) {
    run(60);
    eyes() = {5.25, 1.65, 3.25};
    run(30);
    EXPECT_NEAR(eyes().x, 5.25, 1e-6);
    EXPECT_NEAR(eyes().z, 3.25, 1e-6);
}

TEST_F(PlayerTest, NothingIsBuiltWhereItStands) {
    run(60);
    input().mouse_captured = true;
    app_.world.get<Transform>(camera_).rotation = glm::angleAxis(-1.5f, vec3(1, 0, 0));
    input().buttons_pressed.set(static_cast<std::size_t>(MouseButton::right));
    const std::size_t before = app_.world.resource<VoxelVolumes>().at(app_.world.get<VoxelContent>(blocks_).volume).block_count();
    run(1);
    EXPECT_EQ(app_.world.resource<VoxelVolumes>().at(app_.world.get<VoxelContent>(blocks_).volume).block_count(), before);
}

TEST_F(PlayerTest, TheFlashlightFollowsAndGoesOut) {
    run(2);
    press(Key::f);
    run(1);
    const Entity light = app_.world.resource<Flashlight>().light;
    ASSERT_TRUE(app_.world.alive(light));
    const double before = app_.world.get<WorldTransform>(light).origin.z;
    hold(Key::w);
    run(60);
    EXPECT_LT(app_.world.get<WorldTransform>(light).origin.z, before - 2.0);
    press(Key::f);
    EXPECT_FALSE(app_.world.alive(light));
}

TEST_F(PlayerTest, TheWheelChoosesABlock) {
    run(1);
    input().scroll = -1.0f;
    run(1);
    input().scroll = 0.0f;
    EXPECT_EQ(app_.world.resource<BlockTool>().held, block_palette[1]);
    input().scroll = 2.0f;
    run(1);
    EXPECT_EQ(app_.world.resource<BlockTool>().held, block_palette.back());
}

}  // namespace
}  // namespace sl
