// SPDX-License-Identifier: MIT
#pragma once

#include "editor/scene_edit.h"

namespace sl {

/// The fields of a component of an entity, which must have it, kept inside their ranges. What a person changes
/// goes into the history. Returns whether one did.
bool edit_component(const EditedScene& scene, const ComponentType& type, Entity entity);
/// The same under a header with a button that removes the component.
void component_section(const EditedScene& scene, const ComponentType& type, Entity entity, bool open_at_first);
/// A list of the components that the entity lacks; the chosen one is added.
void add_component_list(const EditedScene& scene, Entity entity);

}  // namespace sl
