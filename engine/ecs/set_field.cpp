// SPDX-License-Identifier: MIT
#include "engine/ecs/set_field.h"

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/core/field_setter.h"
#include "engine/ecs/components/name.h"

namespace sl {

namespace {

struct Assignment {
    std::string_view entity, component, field, value;  ///< entity is empty for all
};

/// The names of components and fields hold no dot, so all dots before the last two belong to the entity's
/// name.
Assignment parsed(std::string_view text) {
    const std::size_t equals = text.find('=');
    const std::string_view left = text.substr(0, equals);
    const std::size_t field_dot = left.rfind('.');
    if (equals == std::string_view::npos || field_dot == std::string_view::npos || field_dot == 0) {
        fail("'{}' sets nothing; write component.field=value or entity.component.field=value",
             for_message(text));
    }
    const std::string_view owner = left.substr(0, field_dot);
    const std::size_t component_dot = owner.rfind('.');
    const bool for_all = component_dot == std::string_view::npos;
    return {.entity = for_all ? std::string_view() : owner.substr(0, component_dot),
            .component = for_all ? owner : owner.substr(component_dot + 1),
            .field = left.substr(field_dot + 1),
            .value = text.substr(equals + 1)};
}

std::vector<Entity> entities_called(const World& world, std::string_view name, std::string_view where) {
    std::vector<Entity> found;
    std::vector<std::string_view> names;
    world.each_entity([&](Entity entity) {
        const Name* known = world.find<Name>(entity);
        if (known == nullptr) return;
        names.push_back(known->value);
        if (known->value == name) found.push_back(entity);
    });
    if (found.empty()) fail("{}: {}", where, no_such_name("entity", name, names));
    return found;
}

}  // namespace

void set_field(World& world, const ComponentRegistry& registry, std::string_view text) {
    const Assignment assignment = parsed(text);
    const std::string shown = for_message(text);
    const ComponentType& type = registry.get(assignment.component, shown);
    std::vector<Entity> entities;
    if (assignment.entity.empty()) {
        world.each_entity([&](Entity entity) { entities.push_back(entity); });
    } else {
        entities = entities_called(world, assignment.entity, shown);
    }
    std::erase_if(entities, [&](Entity entity) { return !type.has(world, entity); });
    if (entities.empty()) {
        fail("{}: {} has the component '{}'", shown,
             assignment.entity.empty() ? "no entity"
                                       : fmt::format("no entity '{}'", for_message(assignment.entity)),
             type.name);
    }
    const std::string_view where = text.substr(0, text.find('=') - assignment.field.size() - 1);
    for (const Entity entity : entities) {
        FieldSetter setter(where, assignment.field, assignment.value);
        type.visit(world, entity, setter);
        setter.check_found();
    }
}

}  // namespace sl
