// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "engine/ecs/query.h"

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

// Every way to walk against the plain definition, in worlds that are aligned, partly aligned and shuffled.
TEST(Query, agrees_with_the_definition_under_random_changes) {
    World world;
    std::mt19937 random(5);
    std::vector<Entity> made;
    for (int i = 0; i < 4000; ++i) made.push_back(world.create(A{i}, B{i}, C{i}));
    for (int round = 0; round < 60; ++round) {
        for (int change = 0; change < 50; ++change) {
            Entity& entity = made[random() % made.size()];
            switch (random() % 6) {
                case 0:
                    world.destroy(entity);
                    entity = world.create(A{round}, B{round});
                    break;
                case 1:
                    world.remove<A>(entity);
                    break;
                case 2:
                    world.remove<B>(entity);
                    break;
                case 3:
                    world.remove<C>(entity);
                    break;
                case 4:
                    world.add(entity, A{round});
                    break;
                default:
                    world.add(entity, B{round});
                    break;
            }
        }
        if (round % 20 == 19) world.align<A, B, C>();
        std::set<Entity> expected_ab;
        std::set<Entity> expected_abc;
        std::set<Entity> expected_ab_not_c;
        world.each_entity([&](Entity entity) {
            if (!world.has<A>(entity) || !world.has<B>(entity)) return;
            expected_ab.insert(entity);
            (world.has<C>(entity) ? expected_abc : expected_ab_not_c).insert(entity);
        });
        std::set<Entity> ab;
        Query<A, const B>(world).each([&](Entity entity, A& a, const B& b) {
            ASSERT_EQ(&a, world.find<A>(entity));
            ASSERT_EQ(&b, world.find<B>(entity));
            ASSERT_TRUE(ab.insert(entity).second);
        });
        ASSERT_EQ(ab, expected_ab);
        std::set<Entity> abc;
        for (auto [entity, a, c, b] : Query<A, C, B>(world)) {
            ASSERT_EQ(&c, world.find<C>(entity));
            ASSERT_TRUE(abc.insert(entity).second);
        }
        ASSERT_EQ(abc, expected_abc);
        std::set<Entity> walked_abc;
        Query<A, C, With<B>>(world).each([&](Entity entity, A&, C&) { walked_abc.insert(entity); });
        ASSERT_EQ(walked_abc, expected_abc);
        std::set<Entity> ab_not_c;
        Query<A, Without<C>, B>(world).each([&](Entity entity, A& a, B& b) {
            ASSERT_EQ(&a, world.find<A>(entity));
            ASSERT_EQ(&b, world.find<B>(entity));
            ab_not_c.insert(entity);
        });
        ASSERT_EQ(ab_not_c, expected_ab_not_c);
        Query<A, Maybe<C>, B>(world).each(
            [&](Entity entity, A&, C* c, B&) { ASSERT_EQ(c, world.find<C>(entity)); });
    }
}

}  // namespace
}  // namespace sl
