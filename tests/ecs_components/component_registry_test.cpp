// SPDX-License-Identifier: MIT
#include "engine/ecs/component_registry.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/field_list.h"
#include "engine/core/field_random.h"
#include "engine/core/fields_json.h"
#include "engine/core/json_text.h"
#include "engine/ecs/components.h"

namespace sl {
namespace {

ComponentRegistry engine_registry() {
    ComponentRegistry registry;
    register_engine_components(registry);
    return registry;
}

std::string written(const World& world, const ComponentType& type, Entity entity) {
    nlohmann::ordered_json object;
    JsonWriter writer(object);
    type.visit_copy(world, entity, writer);
    return json_text(object);
}

TEST(ComponentRegistry, EveryComponentSurvivesJsonWithRandomValues) {
    const ComponentRegistry registry = engine_registry();
    for (const ComponentType& type : registry.types()) {
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            World world;
            const Entity before = world.create(), after = world.create();
            type.add_default(world, before);
            type.add_default(world, after);
            RandomFields random(seed);
            type.visit(world, before, random);
            const std::string text = written(world, type, before);
            const nlohmann::json object = parse_json(text, "x.json");
            JsonReader reader(object, "x.json: ");
            type.visit(world, after, reader);
            reader.check_all_used();
            ASSERT_EQ(written(world, type, after), text) << type.name << " " << seed;
        }
    }
}

TEST(ComponentRegistry, WorksByName) {
    const ComponentRegistry registry = engine_registry();
    World world;
    const Entity entity = world.create();
    const ComponentType& spot = registry.get("spot_light", "here");
    EXPECT_FALSE(spot.has(world, entity));
    spot.add_default(world, entity);
    EXPECT_TRUE(world.has<SpotLight>(entity));
    spot.remove(world, entity);
    EXPECT_FALSE(spot.has(world, entity));
}

TEST(ComponentRegistry, KnowsTheEnginesComponents) {
    const ComponentRegistry registry = engine_registry();
    std::vector<std::string> names;
    for (const ComponentType& type : registry.types()) names.push_back(type.name);
    EXPECT_EQ(names, (std::vector<std::string>{"transform", "camera", "gi", "directional_light", "sun", "day_cycle",
                                               "spot_light", "point_light", "sky", "shape", "material", "model"}));
    EXPECT_EQ(registry.find("tree"), nullptr);
    EXPECT_THROW(registry.get("tree", "here"), Error);
}

TEST(ComponentRegistry, EveryFieldHasHelp) {
    const ComponentRegistry registry = engine_registry();
    for (const ComponentType& type : registry.types()) {
        FieldLister lister;
        type.visit_default(lister);
        EXPECT_FALSE(lister.rows.empty()) << type.name;
        for (const FieldRow& row : lister.rows)
            EXPECT_FALSE(row.help.empty()) << type.name << "." << row.name;
    }
}

TEST(ComponentRegistryDeathTest, RefusesTwoOfAName) {
    ComponentRegistry registry;
    registry.add<Camera>("camera");
    EXPECT_DEATH(registry.add<Shape>("camera"), "two components are called 'camera'");
    EXPECT_DEATH(registry.add<Shape>("parent"), "is a key of entities");
}

}  // namespace
}  // namespace sl
