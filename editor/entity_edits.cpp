// SPDX-License-Identifier: MIT
#include "editor/entity_edits.h"

#include <ranges>

#include "editor/entity_tree.h"
#include "engine/ecs/components/name.h"
#include "engine/ecs/parent.h"

namespace sl {

namespace {

PartValue key_value(const EditedScene& scene, Entity entity) {
    if (!entity) return std::nullopt;
    return fmt::format("{}", static_cast<std::uint64_t>(scene.history.keys().key_of(entity)));
}

}  // namespace

Entity add_entity(const EditedScene& scene, const Transform& place) {
    const std::string name = free_name(scene.world, "entity");
    SceneEdit edit(scene, fmt::format("add {}", name));
    const Entity entity = scene.world.create(Name{name}, place);
    edit.adopt(entity);
    return entity;
}

Entity duplicate_entity(const EditedScene& scene, Entity entity) {
    const std::vector<Entity> originals = with_all_below(scene.world, entity);
    SceneEdit edit(scene, fmt::format("duplicate {}", shown_name(scene.world, entity)));
    std::unordered_map<Entity, Entity> copies;
    const EntityParts parts = scene.parts();
    for (const Entity original : originals) {
        const Entity copy = edit.create(free_name(scene.world, shown_name(scene.world, original)));
        copies[original] = copy;
        for (const std::string_view part : parts.of(original)) {
            if (part != entity_part::name) edit.set(copy, part, parts.read(original, part));
        }
        const Parent* parent = scene.world.find<Parent>(copy);
        if (parent != nullptr && copies.contains(parent->entity)) {
            edit.set(copy, entity_part::parent, key_value(scene, copies[parent->entity]));
        }
    }
    return copies[entity];
}

void delete_entity(const EditedScene& scene, Entity entity) {
    SceneEdit edit(scene, fmt::format("delete {}", shown_name(scene.world, entity)));
    // From below, so that undoing finds each parent there before its children.
    for (const Entity one : with_all_below(scene.world, entity) | std::views::reverse) edit.destroy(one);
}

void set_parent(const EditedScene& scene, Entity entity, Entity parent) {
    SceneEdit edit(scene, fmt::format("parent of {}", shown_name(scene.world, entity)));
    edit.set(entity, entity_part::parent, key_value(scene, parent));
}

void add_component(const EditedScene& scene, Entity entity, const ComponentType& type) {
    SceneEdit edit(scene, fmt::format("add {} to {}", type.name, shown_name(scene.world, entity)));
    edit.set(entity, type.name, default_value(type));
}

void remove_component(const EditedScene& scene, Entity entity, const ComponentType& type) {
    SceneEdit edit(scene, fmt::format("remove {} from {}", type.name, shown_name(scene.world, entity)));
    edit.set(entity, type.name, std::nullopt);
}

}  // namespace sl
