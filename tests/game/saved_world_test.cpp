// SPDX-License-Identifier: MIT
#include "game/saved_world.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "engine/core/clock.h"
#include "engine/ecs/components.h"

namespace sl {
namespace {

class SavedWorldTest : public testing::Test {
  protected:
    std::filesystem::path path_ = std::filesystem::temp_directory_path() / fmt::format("secondlight_saved_{}.world", ::getpid());
    App app_;

    SavedWorldTest() {
        std::filesystem::remove(path_);
        add_voxel_world(app_);
        app_.world.add_resource(FrameClock{});
    }
    ~SavedWorldTest() override { std::filesystem::remove(path_); }

    Entity make_ground() {
        const Entity ground = app_.world.create(Name{"ground"}, Transform{}, VoxelGenerator{});
        app_.schedule.run(app_.world);
        return ground;
    }
    Block block_at(Entity entity, ivec3 cell) {
        return app_.world.resource<VoxelVolumes>().at(app_.world.get<VoxelContent>(entity).volume).get(cell);
    }
};

TEST_F(SavedWorldTest, WhatWasBuiltIsThereAgainWhereItsEntityComesBackAsAnother) {
    const ivec3 first(1, 40, 1), second(2, 41, 2);
    const Entity before = make_ground();
    attach_world(app_, WorldFile::create(path_, "outdoor"));
    set_block(app_.world, before, first, Block::gold);
    app_.schedule.run(app_.world);

    app_.world.destroy(before);
    app_.schedule.run(app_.world);
    const Entity after = make_ground();
    app_.schedule.run(app_.world);
    EXPECT_EQ(block_at(after, first), Block::gold);

    set_block(app_.world, after, second, Block::brick);
    app_.schedule.run(app_.world);
    app_.world.get<VoxelGenerator>(after).seed += 1;
    app_.schedule.run(app_.world);
    EXPECT_EQ(block_at(after, first), Block::gold);
    EXPECT_EQ(block_at(after, second), Block::brick);
    app_.world.resource<SavedWorld>().file.reset();
    EXPECT_EQ(WorldFile::open(path_)->edits().size(), 2u);
}

TEST_F(SavedWorldTest, TheHourIsThereAgainAndWhetherItRuns) {
    const auto open = [&](std::unique_ptr<WorldFile> file) {
        App app;
        add_voxel_world(app);
        app.world.add_resource(FrameClock{.step = 0.0});
        app.world.create(Transform{}, Camera{});
        const Entity sun = app.world.create(Transform{}, SunAngles{}, DirectionalLight{}, DayCycle{.runs = true, .hour = 12.0});
        attach_world(app, std::move(file));
        return std::pair(std::move(app), sun);
    };
    {
        auto [app, sun] = open(WorldFile::create(path_, "crystals"));
        app.world.get<DayCycle>(sun) = {.runs = false, .hour = 17.25, .declination = -0.3f};
        finish_world(app.world);
    }
    auto [app, sun] = open(WorldFile::open(path_));
    const auto& day = app.world.get<DayCycle>(sun);
    EXPECT_EQ(day.hour, 17.25);
    EXPECT_EQ(day.declination, -0.3f);
    EXPECT_FALSE(day.runs);
    EXPECT_LT(app.world.get<SunAngles>(sun).elevation, 0.3f) << "the sun stands where the hour says";
}

TEST_F(SavedWorldTest, AnHourThatIsNoneLeavesTheScenes) {
    WorldFile::create(path_, "crystals")->save_text("day", R"({"hour": "late", "declination": 0, "runs": true})");
    const Entity sun = app_.world.create(Transform{}, SunAngles{}, DirectionalLight{}, DayCycle{.runs = false, .hour = 11.0});
    attach_world(app_, WorldFile::open(path_));
    EXPECT_EQ(app_.world.get<DayCycle>(sun).hour, 11.0);
}

}  // namespace
}  // namespace sl
