// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/world_transform.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/core/field_random.h"

namespace sl {
namespace {

struct WorldTransforms : testing::Test {
    void run() {
        add_world_transforms(world);
        world_transform(Query<const Transform, WorldTransform, Without<Parent>>(world),
                        Query<const Transform, WorldTransform, With<Parent>>(world),
                        Query<const Transform>(world), Query<const Parent>(world), placements);
    }
    const WorldTransform& at(Entity entity) const { return world.get<WorldTransform>(entity); }

    World world;
    Placements placements;
};

const quat quarter_round_y = glm::angleAxis(pi / 2.0f, vec3(0, 1, 0));

TEST_F(WorldTransforms, WithoutParent) {
    const Entity entity = world.create(Transform{{1, 2, 3}, quarter_round_y, {2, 3, 4}});
    run();
    EXPECT_EQ(at(entity).origin, dvec3(1, 2, 3));
    EXPECT_LT(glm::length(at(entity).linear * vec3(0, 0, -1) - vec3(-4, 0, 0)), 1e-5f);
    EXPECT_LT(glm::length(at(entity).linear * vec3(0, 1, 0) - vec3(0, 3, 0)), 1e-6f);
}

TEST_F(WorldTransforms, ChildrenBeforeTheirParents) {
    const Entity child = world.create(Transform{{0, 0, -1}, {1, 0, 0, 0}, {1, 1, 1}});
    const Entity middle = world.create(Transform{{0, 0, -2}, quarter_round_y, {1, 1, 1}});
    const Entity root = world.create(Transform{{10, 0, 0}, quarter_round_y, {3, 3, 3}});
    world.add(child, Parent{middle});
    world.add(middle, Parent{root});
    run();
    // The root's -z is the world's -x, the middle's -z the root's -x, which is the world's +z.
    EXPECT_LT(glm::length(at(middle).origin - dvec3(4, 0, 0)), 1e-6);
    EXPECT_LT(glm::length(at(child).origin - dvec3(4, 0, 3)), 1e-6);
}

TEST_F(WorldTransforms, AnyOrderGivesTheSameBits) {
    std::vector<WorldTransform> first;
    for (int order = 0; order < 4; ++order) {
        World shuffled;
        RandomFields random(3);
        std::vector<Entity> entities(200);
        std::vector<std::size_t> turn(entities.size());
        for (std::size_t i = 0; i < turn.size(); ++i) turn[i] = i;
        for (Entity& entity : entities) entity = shuffled.create();
        if (order == 1) std::reverse(turn.begin(), turn.end());
        if (order > 1) std::rotate(turn.begin(), turn.begin() + 37 * order, turn.end());
        std::vector<Transform> locals(entities.size());
        std::vector<std::size_t> parents(entities.size());
        for (std::size_t i = 0; i < entities.size(); ++i) {
            visit_fields(random, locals[i]);
            locals[i].scale = vec3(1.0f);
            parents[i] = static_cast<std::size_t>(random.uniform() * static_cast<double>(i));
        }
        for (const std::size_t i : turn) {
            shuffled.add(entities[i], locals[i]);
            if (i > 0) shuffled.add(entities[i], Parent{entities[parents[i]]});
        }
        world = std::move(shuffled);
        run();
        for (std::size_t i = 0; i < entities.size(); ++i) {
            if (order == 0) {
                first.push_back(at(entities[i]));
            } else {
                EXPECT_EQ(at(entities[i]).origin, first[i].origin);
                EXPECT_EQ(at(entities[i]).linear, first[i].linear);
            }
        }
    }
}

TEST_F(WorldTransforms, DeepChains) {
    Entity above = world.create(Transform{});
    for (int i = 0; i < 100000; ++i) {
        const Entity below = world.create(Transform{{0, 1, 0}, {1, 0, 0, 0}, {1, 1, 1}});
        world.add(below, Parent{above});
        above = below;
    }
    run();
    EXPECT_EQ(at(above).origin, dvec3(0, 100000, 0));
}

TEST_F(WorldTransforms, ExactFarFromTheOrigin) {
    const Entity planet = world.create(Transform{{1e6, 0, -1e6}, quarter_round_y, {1, 1, 1}});
    const Entity lamp = world.create(Transform{{0.001, 0, 0}, {1, 0, 0, 0}, {1, 1, 1}});
    const Entity far = world.create(Transform{{1e6, 0, 0}, {1, 0, 0, 0}, {1, 1, 1}});
    world.add(lamp, Parent{planet});
    world.add(far, Parent{planet});
    run();
    EXPECT_LT(glm::length(at(lamp).origin - dvec3(1e6, 0, -1e6 - 0.001)), 1e-8);
    // What is left is the rounding of the float quaternion itself: about 1e-7 of 10⁶ m.
    EXPECT_LT(glm::length(at(far).origin - dvec3(1e6, 0, -2e6)), 0.2);
    EXPECT_NEAR(glm::length(at(far).origin - at(planet).origin), 1e6, 1e-8);
}

TEST_F(WorldTransforms, CirclesArePlacedAsIfWithoutParent) {
    const Transform step{{1, 0, 0}, {1, 0, 0, 0}, {1, 1, 1}};
    const Entity a = world.create(step), b = world.create(step), c = world.create(step),
                 below = world.create(step);
    const Entity self = world.create(step);
    world.add(a, Parent{b});
    world.add(b, Parent{c});
    world.add(c, Parent{a});
    world.add(below, Parent{b});
    world.add(self, Parent{self});
    run();
    for (const Entity entity : {a, b, c, self}) EXPECT_EQ(at(entity).origin, dvec3(1, 0, 0));
    EXPECT_EQ(at(below).origin, dvec3(2, 0, 0));
}

TEST_F(WorldTransforms, DeadAndEmptyParentsAddNothing) {
    const Transform step{{1, 0, 0}, {1, 0, 0, 0}, {1, 1, 1}};
    const Entity root = world.create(step), group = world.create(), dead = world.create(step);
    const Entity in_group = world.create(step), orphan = world.create(step), none = world.create(step);
    world.add(group, Parent{root});
    world.add(in_group, Parent{group});
    world.add(orphan, Parent{dead});
    world.add(none, Parent{});
    world.destroy(dead);
    const Entity took_its_index = world.create(Transform{{50, 0, 0}, {1, 0, 0, 0}, {1, 1, 1}});
    ASSERT_EQ(took_its_index.index, dead.index);
    run();
    EXPECT_EQ(at(in_group).origin, dvec3(2, 0, 0));
    EXPECT_EQ(at(orphan).origin, dvec3(1, 0, 0));
    EXPECT_EQ(at(none).origin, dvec3(1, 0, 0));
}

TEST_F(WorldTransforms, FollowsChanges) {
    const Entity root = world.create(Transform{}), child = world.create(Transform{});
    world.add(child, Parent{root});
    run();
    world.get<Transform>(root).translation = dvec3(0, 5, 0);
    run();
    EXPECT_EQ(at(child).origin, dvec3(0, 5, 0));
    world.remove<Parent>(child);
    run();
    EXPECT_EQ(at(child).origin, dvec3(0, 0, 0));
}

TEST_F(WorldTransforms, RotationsOfAnyLengthOnlyRotate) {
    const Entity longer = world.create(Transform{{0, 0, 0}, 2.0f * quarter_round_y, {1, 1, 1}});
    const Entity none = world.create(Transform{{0, 0, 0}, quat(0, 0, 0, 0), {1, 1, 1}});
    run();
    EXPECT_NEAR(glm::determinant(at(longer).linear), 1.0f, 1e-5f);
    EXPECT_EQ(at(none).linear, mat3(1.0f));
}

}  // namespace
}  // namespace sl
