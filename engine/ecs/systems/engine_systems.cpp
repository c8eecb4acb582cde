// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/engine_systems.h"

#include "engine/ecs/component_registry.h"
#include "engine/ecs/systems/animate_models.h"
#include "engine/ecs/systems/build_shapes.h"
#include "engine/ecs/systems/day_cycle.h"
#include "engine/ecs/systems/load_models.h"
#include "engine/ecs/systems/sun_direction.h"
#include "engine/ecs/systems/world_transform.h"

namespace sl {

namespace {

template <class R>
void add_if_missing(World& world) {
    if (world.find_resource<R>() == nullptr) world.emplace_resource<R>();
}

}  // namespace

void add_engine_resources(World& world) {
    add_if_missing<MeshPool>(world);
    add_if_missing<ShapeMeshes>(world);
    add_if_missing<Placements>(world);
    add_if_missing<FrameClock>(world);
    add_if_missing<DayPause>(world);
    if (world.find_resource<ModelLibrary>() == nullptr) world.emplace_resource<ModelLibrary>();
    if (world.find_resource<ComponentRegistry>() == nullptr) {
        register_engine_components(world.emplace_resource<ComponentRegistry>());
    }
}

void add_engine_systems(Schedule& schedule) {
    schedule.add(Stage::simulate, "sun_direction", &sun_direction);
    schedule.add(Stage::simulate, "day_cycle", &day_cycle);
    schedule.add(Stage::simulate, "load_models", &load_models);
    schedule.add(Stage::simulate, "animate_models", &animate_models);
    schedule.add(Stage::derive, "add_world_transforms", &add_world_transforms);
    schedule.add(Stage::derive, "world_transform", &world_transform);
    schedule.add(Stage::mesh, "build_shapes", &build_shapes);
}

}  // namespace sl
