// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/build_shapes.h"

#include <gtest/gtest.h>

#include "engine/ecs/components/transform.h"
#include "engine/ecs/systems/engine_systems.h"

namespace sl {
namespace {

struct BuildShapes : testing::Test {
    BuildShapes() {
        add_engine_resources(world);
        add_engine_systems(schedule);
    }
    void run() { schedule.run(world); }
    MeshPool& meshes() { return world.resource<MeshPool>(); }
    MeshHandle mesh_of(Entity entity) { return world.get<MeshInstance>(entity).mesh; }

    World world;
    Schedule schedule;
};

TEST_F(BuildShapes, DrawsInTheSameFrame) {
    const Entity entity = world.create(Shape{Shape::Kind::box, vec3(2.0f)}, Transform{});
    run();
    EXPECT_EQ(meshes().at(mesh_of(entity)).vertices.size(), 24u);
    EXPECT_EQ(world.get<MeshInstance>(entity).first_material, MeshInstance::own_material);
}

TEST_F(BuildShapes, RebuildsOnlyWhatChanged) {
    const Entity still = world.create(Shape{}), moving = world.create(Shape{});
    run();
    const MeshHandle mesh = mesh_of(moving);
    world.get<Shape>(moving).kind = Shape::Kind::sphere;
    run();
    run();
    EXPECT_EQ(mesh_of(moving), mesh);
    EXPECT_EQ(meshes().at(mesh).version, 1u);
    EXPECT_GT(meshes().at(mesh).vertices.size(), 24u);
    EXPECT_EQ(meshes().at(mesh_of(still)).version, 0u);
}

TEST_F(BuildShapes, ASizeThatIsNotANumberIsBuiltOnce) {
    const Entity entity =
        world.create(Shape{Shape::Kind::box, vec3(std::numeric_limits<float>::quiet_NaN())});
    for (int i = 0; i < 5; ++i) run();
    EXPECT_EQ(meshes().at(mesh_of(entity)).version, 0u);
}

TEST_F(BuildShapes, MeshGoesWithShapeOrEntity) {
    const Entity loses = world.create(Shape{}), dies = world.create(Shape{}), stays = world.create(Shape{});
    run();
    EXPECT_EQ(meshes().size(), 3u);
    world.remove<Shape>(loses);
    world.destroy(dies);
    const Entity same_index = world.create(Shape{Shape::Kind::quad, vec3(1.0f)});
    ASSERT_EQ(same_index.index, dies.index);
    run();
    EXPECT_EQ(meshes().size(), 2u);
    EXPECT_FALSE(world.has<MeshInstance>(loses));
    EXPECT_EQ(meshes().at(mesh_of(same_index)).vertices.size(), 4u);
    EXPECT_NE(meshes().find(mesh_of(stays)), nullptr);
    world.clear();
    run();
    EXPECT_EQ(meshes().size(), 0u);
}

TEST_F(BuildShapes, AnInstanceOfSomebodyElseIsLeftWhenTheShapeGoes) {
    const Entity entity = world.create(Shape{});
    run();
    const MeshHandle other = meshes().insert({});
    world.remove<Shape>(entity);
    world.get<MeshInstance>(entity).mesh = other;
    run();
    EXPECT_EQ(mesh_of(entity), other);
    EXPECT_EQ(meshes().size(), 1u);
}

TEST_F(BuildShapes, WhatOthersTookAwayIsPutBack) {
    const Entity entity = world.create(Shape{});
    run();
    meshes().erase(mesh_of(entity));
    run();
    EXPECT_NE(meshes().find(mesh_of(entity)), nullptr);
    world.remove<MeshInstance>(entity);
    run();
    EXPECT_NE(meshes().find(mesh_of(entity)), nullptr);
    EXPECT_EQ(meshes().size(), 1u);
}

TEST_F(BuildShapes, OneWriterOfWorldTransform) {
    EXPECT_EQ(schedule.writers_of<WorldTransform>(), std::vector<std::string>{"world_transform"});
}

TEST_F(BuildShapes, ResourcesThatAreThereAreKept) {
    meshes().insert({});
    add_engine_resources(world);
    EXPECT_EQ(meshes().size(), 1u);
}

}  // namespace
}  // namespace sl
