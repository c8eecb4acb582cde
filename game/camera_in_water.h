// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/world.h"

namespace sl {

/// Tells whether the active camera is in the water of a voxel entity: its InWater comes and goes. After world_transform.
void camera_in_water(World& world);

}  // namespace sl
