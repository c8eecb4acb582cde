// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/commands.h"
#include "engine/ecs/components/lights.h"
#include "engine/ecs/components/transform.h"
#include "engine/ecs/query.h"

namespace sl {

/// The rotation that turns -z into the direction in which the sun's light travels.
quat sun_rotation(const SunAngles& sun);

/// SunAngles to the rotation of Transform. A sun without a Transform gets one at the end of the stage.
void sun_direction(Query<const SunAngles, Transform> suns, Query<const SunAngles, Without<Transform>> without,
                   Commands& commands);

}  // namespace sl
