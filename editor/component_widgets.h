// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/component_registry.h"

namespace sl {

/// The fields of a component of an entity, which must have it, kept inside their ranges. Returns whether a
/// person changed one.
bool edit_component(World& world, const ComponentType& type, Entity entity);
/// The same under a header with a button that removes the component.
void component_section(World& world, const ComponentType& type, Entity entity, bool open_at_first);
/// A list of the components that the entity lacks; the chosen one is added.
void add_component_list(World& world, const ComponentRegistry& registry, Entity entity);

}  // namespace sl
