// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/ecs/world.h"

namespace sl {

/// What can be done with a component of a type that is known only by name.
struct ComponentType {
    std::string name;  ///< as in scene files, --set and the editor: "spot_light"
    bool (*has)(const World&, Entity);
    void (*add_default)(World&, Entity);
    void (*remove)(World&, Entity);
    /// The entity must have it.
    void (*visit)(World&, Entity, FieldVisitor&);
    /// For visitors that only look: they are shown a copy.
    void (*visit_copy)(const World&, Entity, FieldVisitor&);
    /// Shows a component as it comes, for lists of settings.
    void (*visit_default)(FieldVisitor&);
};

/// The components that people set, by name; a resource. Scene files, --set and the editor know what is added
/// here.
class ComponentRegistry {
  public:
    /// T has visit_fields(FieldVisitor&, T&). Names are unique, and none of a scene entity's own keys.
    template <class T>
    void add(std::string_view name) {
        insert({.name = std::string(name),
                .has = [](const World& world, Entity entity) { return world.has<T>(entity); },
                .add_default = [](World& world, Entity entity) { world.add(entity, T{}); },
                .remove = [](World& world, Entity entity) { world.remove<T>(entity); },
                .visit = [](World& world, Entity entity,
                            FieldVisitor& visit) { visit_fields(visit, world.get<T>(entity)); },
                .visit_copy =
                    [](const World& world, Entity entity, FieldVisitor& visit) {
                        T copy = world.get<T>(entity);
                        visit_fields(visit, copy);
                    },
                .visit_default =
                    [](FieldVisitor& visit) {
                        T component{};
                        visit_fields(visit, component);
                    }});
    }

    /// In order of addition, which is the order in scene files.
    std::span<const ComponentType> types() const { return types_; }
    /// Null where nothing has that name.
    const ComponentType* find(std::string_view name) const;
    /// Throws Error naming the nearest one; `where` begins the message.
    const ComponentType& get(std::string_view name, std::string_view where) const;

  private:
    void insert(ComponentType type);

    std::vector<ComponentType> types_;
};

/// transform, camera, gi, directional_light, sun, spot_light, point_light, sky, shape, material, model.
void register_engine_components(ComponentRegistry& registry);

}  // namespace sl
