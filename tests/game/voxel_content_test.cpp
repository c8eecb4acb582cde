// SPDX-License-Identifier: MIT
#include "game/voxel_content.h"

#include <gtest/gtest.h>

#include "engine/ecs/components.h"
#include "engine/ecs/components/water.h"
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

TEST_F(VoxelContentTest, WaterIsASurfaceApartAndGoesWithIt) {
    const auto surfaces = [&] {
        std::size_t count = 0;
        for ([[maybe_unused]] auto [entity, water] : Query<const WaterSurface>(app_.world)) ++count;
        return count;
    };
    const std::size_t before = app_.world.resource<MeshPool>().size(), others = surfaces();
    // Above everything else, in a chunk of its own.
    const ivec3 cell(2, 100, 2);
    set_block(app_.world, room_, cell, Block::water);
    app_.schedule.run(app_.world);
    EXPECT_EQ(surfaces(), others + 1);
    EXPECT_EQ(app_.world.resource<MeshPool>().size(), before + 2);
    set_block(app_.world, room_, cell, Block::air);
    app_.schedule.run(app_.world);
    EXPECT_EQ(surfaces(), others);
    EXPECT_EQ(app_.world.resource<MeshPool>().size(), before);
}

TEST_F(VoxelContentTest, ACameraKnowsThatItIsInWater) {
    const Entity camera = app_.world.create(Camera{}, Transform{.translation = {1.25, 50.25, 1.25}});
    app_.schedule.run(app_.world);
    EXPECT_FALSE(app_.world.has<InWater>(camera));
    set_block(app_.world, room_, {2, 100, 2}, Block::water);
    app_.schedule.run(app_.world);
    EXPECT_TRUE(app_.world.has<InWater>(camera));
    app_.world.get<Transform>(camera).translation.y += 1.0;
    app_.schedule.run(app_.world);
    EXPECT_FALSE(app_.world.has<InWater>(camera));
}

}  // namespace
}  // namespace sl
