// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/ranges.h>

#include <algorithm>

#include "editor/entity_edits.h"
#include "editor/entity_tree.h"
#include "engine/core/field_clamp.h"
#include "engine/ecs/app.h"
#include "engine/ecs/components.h"
#include "engine/ecs/parent.h"

namespace sl {

/// A scene with a few things in it, and the history of what was done to it.
struct SmallScene {
    App app;
    EditHistory history;

    SmallScene() {
        const Entity house = app.world.create(Name{"house"}, Transform{});
        app.world.create(Name{"lamp"}, SpotLight{}, Transform{}, Parent{house});
        app.world.create(Name{"eye"}, Camera{}, Transform{}, GiSettings{});
    }

    EditedScene edited() { return {app.world, app.registry(), history}; }
    const ComponentType& type(std::string_view name) { return app.registry().get(name, "test"); }
    std::vector<Entity> entities() const { return EntityTree(app.world).all(); }
    Entity find(std::string_view name) const {
        const auto all = entities();
        const auto found = std::ranges::find(all, name, [&](Entity entity) { return std::string_view(shown_name(app.world, entity)); });
        return found == all.end() ? Entity{} : *found;
    }
    void undo() { history.undo(app.world, app.registry()); }
    void redo() { history.redo(app.world, app.registry()); }

    /// As the panel does in each frame in which a widget of the component is moved.
    void change(Entity entity, std::string_view component, FieldVisitor& visitor) {
        const EntityParts parts = edited().parts();
        PartValue before = parts.read(entity, component);
        type(component).visit(app.world, entity, visitor);
        FieldClamp clamp;
        type(component).visit(app.world, entity, clamp);
        history.add_to_gesture("change", {history.keys().key_of(entity), std::string(component), std::move(before),
                                          parts.read(entity, component)});
    }

    /// All that a scene file would hold, whatever the names are and in whatever order the entities lie.
    std::string text() {
        const EntityParts parts = edited().parts();
        std::vector<std::string> entries;
        for (const Entity entity : entities()) {
            std::string entry;
            for (const std::string_view part : parts.of(entity)) entry += fmt::format("{} {}\n", part, *parts.read(entity, part));
            entries.push_back(entry);
        }
        std::ranges::sort(entries);
        return fmt::format("{}", fmt::join(entries, "\n"));
    }
};

}  // namespace sl
