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

}  // namespace
}  // namespace sl
