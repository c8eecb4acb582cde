// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/sun_direction.h"

namespace sl {

quat sun_rotation(const SunAngles& sun) {
    // +z turns towards the sun, up by the elevation first; half a turn, because azimuth 0 is where -z points.
    const quat around = glm::angleAxis(pi - sun.azimuth, vec3(0, 1, 0));
    const quat up = glm::angleAxis(-sun.elevation, vec3(1, 0, 0));
    return glm::normalize(around * up);
}

void sun_direction(Query<const SunAngles, Transform> suns, Query<const SunAngles, Without<Transform>> without,
                   Commands& commands) {
    suns.each([](const SunAngles& sun, Transform& transform) { transform.rotation = sun_rotation(sun); });
    without.each([&](Entity entity, const SunAngles& sun) {
        commands.add(entity, Transform{.rotation = sun_rotation(sun)});
    });
}

}  // namespace sl
