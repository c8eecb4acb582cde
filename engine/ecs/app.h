// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/component_registry.h"
#include "engine/ecs/systems/engine_systems.h"

namespace sl {

/// A world and what runs on it. A plugin is a free function add_something(App&) that adds resources, components and
/// systems.
struct App {
    World world;
    Schedule schedule;

    App() {
        add_engine_resources(world);
        add_engine_systems(schedule);
    }
    ComponentRegistry& registry() { return world.resource<ComponentRegistry>(); }
};

}  // namespace sl
