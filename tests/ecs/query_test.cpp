// SPDX-License-Identifier: MIT
#include "engine/ecs/query.h"

#include <gtest/gtest.h>

#include <map>

namespace sl {
namespace {

struct A {
    int value = 0;
};
struct B {
    int value = 0;
};
struct C {
    int value = 0;
};
struct Hidden {};

TEST(Query, visits_exactly_the_entities_that_have_all) {
    World world;
    world.create(A{1});
    const Entity both = world.create(A{2}, B{20});
    world.create(B{30});
    int visits = 0;
    Query<const A, B>(world).each([&](Entity entity, const A& a, B& b) {
        EXPECT_EQ(entity, both);
        b.value += a.value;
        ++visits;
    });
    EXPECT_EQ(visits, 1);
    EXPECT_EQ(world.get<B>(both).value, 22);
}

TEST(Query, the_entity_may_be_left_out) {
    World world;
    world.create(A{1}, B{2});
    int sum = 0;
    Query<const A, const B>(world).each([&](const A& a, const B& b) { sum = a.value + b.value; });
    EXPECT_EQ(sum, 3);
}

TEST(Query, range_for_gives_entity_and_references) {
    World world;
    const Entity entity = world.create(A{1}, B{2});
    world.create(A{5});
    int visits = 0;
    for (auto [found, a, b] : Query<const A, B>(world)) {
        static_assert(std::is_same_v<decltype(a), const A&>);
        static_assert(std::is_same_v<decltype(b), B&>);
        EXPECT_EQ(found, entity);
        b.value = 10 * a.value;
        ++visits;
    }
    EXPECT_EQ(visits, 1);
    EXPECT_EQ(world.get<B>(entity).value, 10);
}

TEST(Query, of_a_const_world_only_reads) {
    static_assert(std::is_constructible_v<Query<const A, Maybe<const B>, Without<C>>, const World&>);
    static_assert(!std::is_constructible_v<Query<A>, const World&>);
    static_assert(!std::is_constructible_v<Query<const A, Maybe<B>>, const World&>);
    World world;
    world.create(A{7});
    EXPECT_EQ(std::get<1>(*Query<const A>(std::as_const(world)).first()).value, 7);
}

TEST(Query, over_components_that_nobody_has_is_empty) {
    World world;
    world.create(A{1});
    const Query<const A, B> query(world);
    query.each([](const A&, B&) { FAIL(); });
    for ([[maybe_unused]] auto item : query) FAIL();
    EXPECT_EQ(query.size_hint(), 0u);
    EXPECT_FALSE(query.first());
    EXPECT_FALSE(query.contains({0, 1}));
}

TEST(Query, size_hint_is_the_smallest_pool) {
    World world;
    for (int i = 0; i < 10; ++i) world.create(A{});
    for (int i = 0; i < 3; ++i) world.create(B{});
    EXPECT_EQ((Query<A, B>(world).size_hint()), 3u);
    EXPECT_EQ((Query<A>(world).size_hint()), 10u);
    EXPECT_FALSE((Query<A, B>(world).first()));
}

TEST(Query, find_looks_one_entity_up) {
    World world;
    const Entity with = world.create(A{1}, B{2});
    const Entity without = world.create(A{3});
    const Query<const A, B> query(world);
    ASSERT_TRUE(query.find(with));
    std::get<2>(*query.find(with)).value = 9;
    EXPECT_EQ(world.get<B>(with).value, 9);
    EXPECT_TRUE(query.contains(with));
    EXPECT_FALSE(query.find(without));
    EXPECT_FALSE(query.contains({}));
}

TEST(Query, filters_select_and_maybe_gives_a_pointer) {
    World world;
    const Entity plain = world.create(A{1});
    const Entity with_b = world.create(A{2}, B{20});
    world.create(A{3}, Hidden{});
    const Entity with_c = world.create(A{4}, C{40});
    std::map<Entity, int> seen;
    Query<const A, Maybe<B>, Without<Hidden>>(world).each(
        [&](Entity entity, const A& a, B* b) { seen[entity] = b == nullptr ? a.value : b->value; });
    EXPECT_EQ(seen, (std::map<Entity, int>{{plain, 1}, {with_b, 20}, {with_c, 4}}));

    int visits = 0;
    for (auto [entity, a] : Query<const A, With<C>>(world)) {
        EXPECT_EQ(entity, with_c);
        EXPECT_EQ(a.value, 4);
        ++visits;
    }
    EXPECT_EQ(visits, 1);
}

TEST(Query, filters_over_pools_that_do_not_exist) {
    World world;
    world.create(A{1});
    int visits = 0;
    Query<A, Without<Hidden>, Maybe<const B>>(world).each([&](A&, const B* b) {
        EXPECT_EQ(b, nullptr);
        ++visits;
    });
    EXPECT_EQ(visits, 1);
    EXPECT_FALSE((Query<A, With<Hidden>>(world).first()));
}

TEST(Query, notices_changes_between_walks) {
    World world;
    std::vector<Entity> made;
    for (int i = 0; i < 3000; ++i) made.push_back(world.create(A{1}, B{1}));
    const Query<const A, const B> query(world);
    const auto sum = [&] {
        int total = 0;
        query.each([&](const A& a, const B& b) { total += a.value * b.value; });
        return total;
    };
    EXPECT_EQ(sum(), 3000);
    world.remove<B>(made[5]);
    EXPECT_EQ(sum(), 2999);
    world.destroy(made[2000]);
    EXPECT_EQ(sum(), 2998);
    world.add(made[5], B{3});
    EXPECT_EQ(sum(), 3001);
}

TEST(Query, may_walk_inside_a_walk) {
    World world;
    for (int i = 0; i < 50; ++i) world.create(A{1}, B{1});
    int pairs = 0;
    const Query<const A, const B> query(world);
    query.each([&](const A&, const B&) { query.each([&](const A&, const B&) { ++pairs; }); });
    EXPECT_EQ(pairs, 2500);
    world.create(A{});  // both walks are over, the pools are free again
}

TEST(QueryDeathTest, changing_a_walked_pool_stops) {
    World world;
    const Entity entity = world.create(A{1}, B{1});
    const Query<const A, B> query(world);
    EXPECT_DEATH(query.each([&](const A&, B&) { world.create(A{2}); }), "use Commands");
    EXPECT_DEATH(query.each([&](const A&, B&) { world.destroy(entity); }), "use Commands");
    EXPECT_DEATH(query.each([&](const A&, B&) { world.remove<B>(entity); }), "use Commands");
    query.each([&](const A&, B&) { world.add(entity, C{1}); });
    EXPECT_TRUE(world.has<C>(entity)) << "a pool outside the query may change";
    const auto walk_with_range_for = [&] {
        for ([[maybe_unused]] auto item : query) world.create(A{2});
    };
    EXPECT_DEATH(walk_with_range_for(), "use Commands");
}

TEST(Query, an_exception_frees_the_pools) {
    World world;
    world.create(A{1});
    EXPECT_THROW(Query<A>(world).each([](A&) { throw 1; }), int);
    world.create(A{2});
    EXPECT_EQ(world.entity_count(), 2u);
}

}  // namespace
}  // namespace sl
