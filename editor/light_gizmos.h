// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/world.h"

namespace sl {

/// Draws over the picture how far and whereto the entity's light shines: a spot's cones, a point light's range,
/// the direction of sunlight before the camera. Nothing without an active camera. `scale` is of widgets.
void draw_light_gizmos(World& world, Entity entity, float scale);

}  // namespace sl
