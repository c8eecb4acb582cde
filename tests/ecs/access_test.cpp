// SPDX-License-Identifier: MIT
#include "engine/ecs/access.h"

#include <gtest/gtest.h>

namespace sl {
namespace {

struct A {};
struct B {};
struct C {};
struct D {};
struct Clock {
    double seconds = 0.0;
};
struct Input {};

void no_parameters() {}
void queries(Query<const A, B>, Query<Maybe<const C>, Maybe<D>, const A>) {}
void filters(Query<const A, With<B>, Without<C>>) {}
void resources(const Clock&, Input&) {}
void both_ways(Query<const A>, Query<A>, const Query<const A>&) {}
void commands(Commands&, const Clock&) {}
void whole_world(World&) {}
void reads_whole_world(const World&, Query<A>) {}

TEST(Access, const_components_and_resources_are_read_the_others_written) {
    EXPECT_EQ(describe_reads(access_of(&queries)), "A, C");
    EXPECT_EQ(describe_writes(access_of(&queries)), "B, D");
    EXPECT_EQ(describe_reads(access_of(&resources)), "Clock");
    EXPECT_EQ(describe_writes(access_of(&resources)), "Input");
    EXPECT_EQ(describe_reads(access_of(&no_parameters)), "-");
    EXPECT_EQ(describe_writes(access_of(&no_parameters)), "-");
}

TEST(Access, filters_touch_no_values) {
    EXPECT_EQ(describe_reads(access_of(&filters)), "A");
    EXPECT_EQ(describe_writes(access_of(&filters)), "-");
}

TEST(Access, what_is_written_is_listed_once) {
    const Access access = access_of(&both_ways);
    EXPECT_EQ(describe_reads(access), "-");
    EXPECT_EQ(describe_writes(access), "A");
    EXPECT_TRUE(access.writes_type(typeid(A)));
    EXPECT_FALSE(access.reads_type(typeid(A)));
}

TEST(Access, commands_and_worlds) {
    EXPECT_EQ(describe_writes(access_of(&commands)), "Commands");
    EXPECT_EQ(describe_writes(access_of(&whole_world)), "everything");
    EXPECT_TRUE(access_of(&whole_world).writes_type(typeid(Clock)));
    const Access reader = access_of(&reads_whole_world);
    EXPECT_EQ(describe_reads(reader), "everything");
    EXPECT_EQ(describe_writes(reader), "A");
    EXPECT_TRUE(reader.reads_type(typeid(Clock)));
    EXPECT_FALSE(reader.writes_type(typeid(Clock)));
}

TEST(Access, parameters_are_filled_from_the_world) {
    World world;
    Commands recorded(world);
    Clock& clock = world.add_resource(Clock{2.0});
    world.create(A{});
    EXPECT_EQ(&SystemParam<Clock&>::fetch(world, recorded), &clock);
    EXPECT_EQ(&SystemParam<const Clock&>::fetch(world, recorded), &clock);
    EXPECT_EQ(&SystemParam<World&>::fetch(world, recorded), &world);
    EXPECT_EQ(&SystemParam<Commands&>::fetch(world, recorded), &recorded);
    EXPECT_EQ(SystemParam<Query<const A>>::fetch(world, recorded).size_hint(), 1u);
}

}  // namespace
}  // namespace sl
