// SPDX-License-Identifier: MIT
#include "editor/scene_edit.h"

#include <ranges>

namespace sl {

SceneEdit::~SceneEdit() {
    if (!step_.changes.empty()) scene_.history.add(std::move(step_));
}

Entity SceneEdit::create(std::string name) {
    const Entity entity = scene_.world.create();
    note(entity, entity_part::existence, std::nullopt, "");
    set(entity, entity_part::name, std::move(name));
    return entity;
}

void SceneEdit::set(Entity entity, std::string_view part, const PartValue& value) {
    const EntityParts parts = scene_.parts();
    PartValue before = parts.read(entity, part);
    if (before == value) return;
    parts.write(entity, part, value);
    note(entity, part, std::move(before), value);
}

void SceneEdit::destroy(Entity entity) {
    const EntityParts parts = scene_.parts();
    for (const std::string_view part : parts.of(entity) | std::views::reverse) {
        note(entity, part, parts.read(entity, part), std::nullopt);
    }
    note(entity, entity_part::existence, "", std::nullopt);
    scene_.world.destroy(entity);
}

void SceneEdit::adopt(Entity entity) {
    const EntityParts parts = scene_.parts();
    note(entity, entity_part::existence, std::nullopt, "");
    for (const std::string_view part : parts.of(entity)) {
        note(entity, part, std::nullopt, parts.read(entity, part));
    }
}

void SceneEdit::note(Entity entity, std::string_view part, PartValue before, PartValue after) {
    step_.changes.push_back(
        {scene_.history.keys().key_of(entity), std::string(part), std::move(before), std::move(after)});
}

}  // namespace sl
