// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/world.h"

namespace sl {

/// The entity of the camera that is rendered; null when there is none.
Entity active_camera(World& world);

}  // namespace sl
