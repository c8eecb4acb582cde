// SPDX-License-Identifier: MIT
#include "engine/ecs/commands.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "engine/ecs/parent.h"
#include "engine/ecs/query.h"

namespace sl {
namespace {

struct Label {
    std::string text;
};
struct Health {
    int points = 0;
};
struct Owned {
    std::unique_ptr<int> value;
};

TEST(Commands, nothing_but_names_before_apply) {
    World world;
    const Entity old = world.create(Health{3});
    Commands commands(world);
    const Entity fresh = commands.create(Label{"new"});
    commands.add(old, Label{"old"});
    commands.destroy(old);
    EXPECT_FALSE(commands.empty());
    EXPECT_TRUE(world.alive(old));
    EXPECT_FALSE(world.has<Label>(fresh));
    commands.apply(world);
    EXPECT_TRUE(commands.empty());
    EXPECT_FALSE(world.alive(old));
    EXPECT_EQ(world.get<Label>(fresh).text, "new");
}

TEST(Commands, a_created_name_can_be_stored_at_once) {
    World world;
    Commands commands(world);
    const Entity parent = commands.create();
    const Entity child = commands.create();
    EXPECT_NE(parent, child);
    commands.add(child, Parent{parent});
    commands.add(parent, Label{"parent"});
    commands.apply(world);
    EXPECT_EQ(world.get<Label>(world.get<Parent>(child).entity).text, "parent");
}

TEST(Commands, run_in_the_order_recorded) {
    World world;
    const Entity entity = world.create();
    Commands commands(world);
    commands.add(entity, Health{1});
    commands.add(entity, Health{2});
    commands.add(entity, Label{"x"});
    commands.remove<Label>(entity);
    commands.remove<Health>(entity);
    commands.add(entity, Health{3});
    commands.apply(world);
    EXPECT_EQ(world.get<Health>(entity).points, 3);
    EXPECT_FALSE(world.has<Label>(entity));
}

TEST(Commands, for_the_dead_are_dropped) {
    World world;
    const Entity first = world.create(Health{1});
    const Entity second = world.create(Health{2});
    Commands commands(world);
    commands.destroy(first);
    commands.add(first, Label{"late"});
    commands.add(second, Label{"late"});
    commands.remove<Health>(second);
    commands.destroy(second);
    world.destroy(second);
    const Entity taker = world.create(Health{9});
    ASSERT_EQ(taker.index, second.index);
    commands.apply(world);
    EXPECT_FALSE(world.alive(first));
    EXPECT_EQ(world.get<Health>(taker).points, 9);
    EXPECT_FALSE(world.has<Label>(taker));
}

TEST(Commands, may_be_recorded_while_a_query_walks) {
    World world;
    for (int i = 0; i < 100; ++i) world.create(Health{i});
    Commands commands(world);
    Query<const Health>(world).each([&](Entity entity, const Health& health) {
        if (health.points % 2 == 0) commands.destroy(entity);
        commands.create(Health{1000});
    });
    commands.apply(world);
    EXPECT_EQ(world.entity_count(), 150u);
    EXPECT_EQ(world.pool<Health>().size(), 150u);
}

TEST(Commands, carry_values_that_only_move_and_can_be_used_again) {
    World world;
    Commands commands(world);
    for (int round = 0; round < 3; ++round) {
        const Entity entity = commands.create(Owned{std::make_unique<int>(round)});
        commands.apply(world);
        EXPECT_EQ(*world.get<Owned>(entity).value, round);
    }
    EXPECT_EQ(world.entity_count(), 3u);
}

TEST(CommandsDeathTest, another_world_is_a_mistake) {
    World world;
    World other;
    Commands commands(world);
    EXPECT_DEATH(commands.apply(other), "applied to another");
}

}  // namespace
}  // namespace sl
