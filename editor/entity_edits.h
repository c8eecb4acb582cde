// SPDX-License-Identifier: MIT
#pragma once

#include "editor/scene_edit.h"
#include "engine/ecs/components/transform.h"

namespace sl {

// Each of these is one step in the history.

/// A new entity at a place, called "entity" or, where that is taken, "entity 2" and so on.
Entity add_entity(const EditedScene& scene, const Transform& place);
/// The entity with all below it, under new names beside the old one. Returns the copy.
Entity duplicate_entity(const EditedScene& scene, Entity entity);
/// With all below it. What systems made for them goes with their next run.
void delete_entity(const EditedScene& scene, Entity entity);
/// Null lets it stand in the world. The entity keeps its Transform, and so may move. It must not be below
/// itself afterwards: see is_below.
void set_parent(const EditedScene& scene, Entity entity, Entity parent);
void add_component(const EditedScene& scene, Entity entity, const ComponentType& type);
void remove_component(const EditedScene& scene, Entity entity, const ComponentType& type);

}  // namespace sl
