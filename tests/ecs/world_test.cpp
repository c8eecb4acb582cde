// SPDX-License-Identifier: MIT
#include "engine/ecs/world.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <random>
#include <string>

namespace sl {
namespace {

struct Position {
    float x = 0.0f;
    float y = 0.0f;
};
struct Label {
    std::string text;
};
struct Tag {};
template <int I>
struct Numbered {
    int value = I;
};

TEST(World, creates_entities_with_components) {
    World world;
    const Entity entity = world.create(Position{1.0f, 2.0f}, Label{"lamp"});
    EXPECT_TRUE(world.alive(entity));
    EXPECT_EQ(world.get<Position>(entity).y, 2.0f);
    EXPECT_EQ(std::as_const(world).get<Label>(entity).text, "lamp");
    EXPECT_FALSE(world.has<Tag>(entity));
    EXPECT_EQ(world.entity_count(), 1u);
    EXPECT_TRUE(world.alive(world.create()));
}

TEST(World, a_stale_name_is_not_the_entity_that_took_its_place) {
    World world;
    const Entity old = world.create(Position{1.0f, 0.0f});
    world.destroy(old);
    const Entity fresh = world.create(Position{2.0f, 0.0f});
    ASSERT_EQ(fresh.index, old.index);
    EXPECT_NE(fresh, old);
    EXPECT_FALSE(world.alive(old));
    EXPECT_EQ(world.find<Position>(old), nullptr);
    EXPECT_FALSE(world.has<Position>(old));
    world.destroy(old);
    EXPECT_TRUE(world.alive(fresh));
    EXPECT_EQ(world.get<Position>(fresh).x, 2.0f);
}

TEST(World, null_and_foreign_names_are_dead) {
    World world;
    EXPECT_FALSE(world.alive({}));
    EXPECT_FALSE(world.alive({12, 1}));
    EXPECT_EQ(world.find<Position>({}), nullptr);
    world.destroy({});
    world.destroy(world.create());
    EXPECT_FALSE(world.alive({0, 2})) << "the generation of a free record";
}

TEST(World, add_replaces_and_remove_of_nothing_does_nothing) {
    World world;
    const Entity entity = world.create();
    world.add(entity, Label{"a"});
    EXPECT_EQ(world.add(entity, Label{"b"}).text, "b");
    world.add<Tag>(entity);
    EXPECT_TRUE(world.has<Tag>(entity));
    world.remove<Tag>(entity);
    world.remove<Tag>(entity);
    world.remove<Position>(entity);
    EXPECT_FALSE(world.has<Tag>(entity));
    EXPECT_EQ(world.get<Label>(entity).text, "b");
}

TEST(World, each_entity_visits_the_living_even_while_it_destroys_and_creates) {
    World world;
    std::vector<Entity> made;
    for (int i = 0; i < 10; ++i) made.push_back(world.create());
    world.destroy(made[4]);
    int visited = 0;
    world.each_entity([&](Entity entity) {
        ++visited;
        world.destroy(entity);
        if (visited == 9) {
            for (int i = 0; i < 20; ++i) world.create();
        }
    });
    EXPECT_EQ(visited, 9);
    EXPECT_EQ(world.entity_count(), 20u);
}

TEST(World, clear_keeps_resources_and_staleness) {
    World world;
    world.add_resource(Label{"sun"});
    const Entity old = world.create(Position{}, Label{"x"});
    const Entity older = world.create();
    world.destroy(older);
    world.clear();
    EXPECT_EQ(world.entity_count(), 0u);
    EXPECT_FALSE(world.alive(old));
    EXPECT_EQ(world.resource<Label>().text, "sun");
    const Entity fresh = world.create(Label{"y"});
    EXPECT_EQ(fresh.index, 0u);
    EXPECT_FALSE(world.alive(old));
    EXPECT_FALSE(world.alive(older));
    EXPECT_FALSE(world.has<Position>(fresh));
    world.destroy(fresh);
    EXPECT_EQ(world.entity_count(), 0u);
}

template <int... I>
Entity create_with_all(World& world, std::integer_sequence<int, I...>) {
    return world.create(Numbered<I>{}...);
}
template <int... I>
int count_components(const World& world, Entity entity, std::integer_sequence<int, I...>) {
    return (static_cast<int>(world.has<Numbered<I>>(entity)) + ...);
}

TEST(World, destroy_reaches_every_pool_beyond_64_component_types) {
    constexpr auto all = std::make_integer_sequence<int, 80>{};
    World world;
    const Entity keep = create_with_all(world, all);
    const Entity gone = create_with_all(world, all);
    world.remove<Numbered<79>>(gone);
    EXPECT_EQ(count_components(world, gone, all), 79);
    world.destroy(gone);
    EXPECT_EQ(count_components(world, gone, all), 0);
    EXPECT_EQ(count_components(world, keep, all), 80);
    EXPECT_EQ(world.pool<Numbered<78>>().size(), 1u);
}

TEST(World, can_be_moved) {
    World world;
    const Entity entity = world.create(Label{"a"});
    World other = std::move(world);
    EXPECT_EQ(other.get<Label>(entity).text, "a");
}

TEST(World, align_puts_shared_entities_first_and_in_one_order) {
    World world;
    std::vector<Entity> made;
    for (int i = 0; i < 3000; ++i) made.push_back(world.create());
    std::mt19937 random(3);
    const auto add_shuffled = [&]<class T>(std::uint32_t one_in) {
        std::shuffle(made.begin(), made.end(), random);
        for (const Entity entity : made) {
            if (random() % one_in == 0) world.add(entity, T{static_cast<int>(entity.index)});
        }
    };
    add_shuffled.operator()<Numbered<0>>(1);
    add_shuffled.operator()<Numbered<1>>(2);
    add_shuffled.operator()<Numbered<2>>(3);
    world.align<Numbered<0>, Numbered<1>, Numbered<2>>();

    std::size_t shared = 0;
    for (const Entity entity : made)
        shared += world.has<Numbered<1>>(entity) && world.has<Numbered<2>>(entity) ? 1 : 0;
    ASSERT_GT(shared, 300u);
    for (std::size_t i = 0; i < shared; ++i) {
        const Entity entity = world.pool<Numbered<0>>().entities()[i];
        ASSERT_EQ(world.pool<Numbered<1>>().entities()[i], entity);
        ASSERT_EQ(world.pool<Numbered<2>>().entities()[i], entity);
    }
    for (const Entity entity : made) {
        ASSERT_EQ(world.get<Numbered<0>>(entity).value, static_cast<int>(entity.index));
        if (const auto* number = world.find<Numbered<1>>(entity)) {
            ASSERT_EQ(number->value, static_cast<int>(entity.index));
        }
    }
}

struct Model {
    std::optional<float> x;
    std::optional<std::string> text;
};

TEST(World, behaves_like_a_map_under_random_changes) {
    World world;
    std::map<Entity, Model> model;
    std::vector<Entity> ever;
    std::mt19937 random(4);
    for (int step = 0; step < 20'000; ++step) {
        const auto choice = random() % 10;
        if (choice < 3 || ever.empty()) {
            const auto x = static_cast<float>(step);
            const Entity entity = choice == 0 ? world.create() : world.create(Position{x, 0.0f});
            ASSERT_EQ(model.count(entity), 0u);
            model[entity].x = choice == 0 ? std::nullopt : std::optional(x);
            ever.push_back(entity);
            continue;
        }
        const Entity entity = ever[random() % ever.size()];
        const auto known = model.find(entity);
        ASSERT_EQ(world.alive(entity), known != model.end());
        if (choice < 5) {
            world.destroy(entity);
            if (known != model.end()) model.erase(known);
        } else if (known != model.end()) {
            if (choice < 7) {
                world.add(entity, Label{std::to_string(step)});
                known->second.text = std::to_string(step);
            } else if (choice == 7) {
                world.remove<Label>(entity);
                known->second.text.reset();
            } else if (choice == 8) {
                world.remove<Position>(entity);
                known->second.x.reset();
            }
        }
        if (step % 400 != 0) continue;
        ASSERT_EQ(world.entity_count(), model.size());
        for (const auto& [living, expected] : model) {
            const Position* position = world.find<Position>(living);
            const Label* label = world.find<Label>(living);
            ASSERT_EQ(position != nullptr, expected.x.has_value());
            ASSERT_EQ(label != nullptr, expected.text.has_value());
            if (position != nullptr) {
                ASSERT_EQ(position->x, *expected.x);
            }
            if (label != nullptr) {
                ASSERT_EQ(label->text, *expected.text);
            }
        }
    }
}

TEST(WorldDeathTest, mistakes_stop_and_say_which_entity_and_component) {
    World world;
    const Entity entity = world.create();
    EXPECT_DEATH(world.get<Position>(entity), "entity 0 \\(generation 1\\) has no Position");
    EXPECT_DEATH(world.resource<Position>(), "no resource Position");
    world.destroy(entity);
    EXPECT_DEATH(world.get<Position>(entity), "is dead and has no Position");
    EXPECT_DEATH(world.add(entity, Position{}), "entity 0 \\(generation 1\\) is dead");
    EXPECT_DEATH(world.remove<Position>(entity), "is dead");
}

}  // namespace
}  // namespace sl
