// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/component_registry.h"

namespace sl {

/// "component.field=value" sets the field on every entity that has the component,
/// "entity.component.field=value" on the entities of that name: gi.strength=0.3,
/// lamp.spot_light.outer_cone=30deg. Throws Error where nothing has it, or the value does not fit; entities
/// before that one keep the new value.
void set_field(World& world, const ComponentRegistry& registry, std::string_view assignment);

}  // namespace sl
