// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include "engine/core/field_list.h"
#include "engine/core/field_random.h"
#include "engine/ecs/components/model_file.h"
#include "engine/ecs/components/name.h"
#include "engine/ecs/component_registry.h"
#include "engine/ecs/parent.h"

namespace sl {

/// Thirty entities with some of all components, random values in every field but texts, and parents.
inline void fill_randomly(World& world, const ComponentRegistry& registry, std::uint64_t seed) {
    RandomFields random(seed);
    std::vector<Entity> entities;
    for (std::size_t i = 0; i < 30; ++i) {
        const Entity entity = world.create(Name{fmt::format("entity \"{}\" ü", i)});
        for (const ComponentType& type : registry.types()) {
            if (random.uniform() < 0.5) continue;
            type.add_default(world, entity);
            type.visit(world, entity, random);
        }
        if (auto* model = world.find<ModelFile>(entity)) model->file = fmt::format("models/\\ {}.glb", i);
        if (i > 0 && random.uniform() < 0.5) world.add(entity, Parent{entities[i / 2]});
        entities.push_back(entity);
    }
}

/// All that a scene file tells of a world, one line a field, with every digit.
inline std::string told(const World& world, const ComponentRegistry& registry) {
    std::string text;
    world.each_entity([&](Entity entity) {
        const Parent* parent = world.find<Parent>(entity);
        text += fmt::format("{} below '{}'\n", world.get<Name>(entity).value, parent == nullptr ? "" : world.get<Name>(parent->entity).value);
        for (const ComponentType& type : registry.types()) {
            if (!type.has(world, entity)) continue;
            FieldLister lister;
            type.visit_copy(world, entity, lister);
            for (const FieldRow& row : lister.rows) text += fmt::format("  {}.{} {}\n", type.name, row.name, row.value);
        }
    });
    return text;
}

}  // namespace sl
