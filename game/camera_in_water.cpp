// SPDX-License-Identifier: MIT
#include "game/camera_in_water.h"

#include "engine/ecs/components/transform.h"
#include "engine/ecs/components/water.h"
#include "engine/ecs/query.h"
#include "game/player/voxel_surroundings.h"
#include "game/session.h"

namespace sl {

void camera_in_water(World& world) {
    const Entity camera = active_camera(world);
    const auto* place = camera ? world.find<WorldTransform>(camera) : nullptr;
    const bool wet = place != nullptr && voxel_surroundings(world).water(place->origin);
    std::vector<Entity> dry;
    for (auto [entity, in_water] : Query<const InWater>(world)) {
        if (!wet || entity != camera) dry.push_back(entity);
    }
    for (const Entity entity : dry) world.remove<InWater>(entity);
    if (wet && !world.has<InWater>(camera)) world.add(camera, InWater{});
}

}  // namespace sl
