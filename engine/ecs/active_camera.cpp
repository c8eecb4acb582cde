// SPDX-License-Identifier: MIT
#include "engine/ecs/active_camera.h"

#include "engine/ecs/components/camera.h"
#include "engine/ecs/query.h"

namespace sl {

Entity active_camera(World& world) {
    for (auto [entity, camera] : Query<const Camera>(world)) {
        if (camera.active) return entity;
    }
    return {};
}

}  // namespace sl
