// SPDX-License-Identifier: MIT
#include "game/voxel_content.h"

#include <gtest/gtest.h>

#include "engine/ecs/components.h"
#include "engine/ecs/query.h"

namespace sl {
namespace {

/// A world with one small room of blocks.
class VoxelContentTest : public testing::Test {
  protected:
    App app_;
    Entity room_;

    VoxelContentTest() {
        add_voxel_world(app_);
        room_ = app_.world.create(VoxelGenerator{}, Transform{});
        app_.schedule.run(app_.world);
    }
    std::size_t volumes() const { return app_.world.resource<VoxelVolumes>().size(); }
    std::size_t meshes() {
        std::size_t count = 0;
        for ([[maybe_unused]] auto [entity, mesh] : Query<const MeshInstance>(app_.world)) ++count;
        return count;
    }
};

TEST_F(VoxelContentTest, AGeneratorGivesBlocksAndMeshes) {
    EXPECT_EQ(volumes(), 1u);
    EXPECT_GT(meshes(), 0u);
}

TEST_F(VoxelContentTest, ADestroyedEntityLeavesNothingBehind) {
    app_.world.destroy(room_);
    app_.schedule.run(app_.world);
    EXPECT_EQ(volumes(), 0u);
    EXPECT_EQ(meshes(), 0u);
}

TEST_F(VoxelContentTest, NorDoesOneThatLostItsGenerator) {
    app_.world.remove<VoxelGenerator>(room_);
    app_.schedule.run(app_.world);
    EXPECT_EQ(volumes(), 0u);
    EXPECT_EQ(meshes(), 0u);
    EXPECT_FALSE(app_.world.has<VoxelContent>(room_));
}

TEST_F(VoxelContentTest, ChangedSettingsReplaceTheBlocks) {
    app_.world.get<VoxelGenerator>(room_).width = 12;
    app_.schedule.run(app_.world);
    EXPECT_EQ(volumes(), 1u);
    EXPECT_EQ(app_.world.get<VoxelContent>(room_).made_by.width, 12u);
}

}  // namespace
}  // namespace sl
