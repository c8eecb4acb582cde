// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/world.h"

namespace sl {

/// Puts the nodes, joints and morphs of all models where their animations have them at the frame's time. After load_models.
void animate_models(World& world);

}  // namespace sl
