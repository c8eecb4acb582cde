// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/world.h"
#include "game/player/body.h"

namespace sl {

/// The blocks of all voxel entities as something to walk on. What is turned against the axes counts as large as the box
/// around it. Holds no copies: good until entities or volumes change.
/// Land that is still to come is solid.
Surroundings voxel_surroundings(World& world);

/// Whether all land that a box in world space reaches into is loaded.
bool land_is_there(World& world, const BodyBox& box);

}  // namespace sl
