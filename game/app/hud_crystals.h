// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/world.h"

namespace sl {

/// How many crystals are awake; of the one that is near, what light it waits for and what light it gets; the hint that was
/// asked for; and sparks when one wakes. Nothing in worlds without crystals. Behind all ImGui windows.
void draw_crystal_search(World& world);

}  // namespace sl
