// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/ecs/world.h"

namespace sl {

/// Makes one of a world's cameras the only active one: by its name, which a model's has in its file, or by its number from 0.
/// Throws Error naming the cameras.
void choose_camera(World& world, const std::string& camera);

}  // namespace sl
