// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/app.h"

namespace sl {

/// What the player carries; a resource.
struct Flashlight {
    Entity light;  ///< null while it is off
};

/// F switches a spot light that follows the active camera on and off. Its cone throws shadows and bounces.
void flashlight(World& world);

/// The flashlight as a plugin.
void add_flashlight(App& app);

}  // namespace sl
