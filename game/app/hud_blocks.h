// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/app.h"

namespace sl {

/// Pictures of the blocks that the keys 1 to 9 choose, at the foot of the screen, the held one framed.
void draw_hotbar(World& world);

/// The edges of the block that a click would break, where the camera sees them.
void draw_block_outline(World& world);

}  // namespace sl
