// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "engine/ecs/component_registry.h"

namespace sl {

/// The words of a command line that captures what the active camera sees: its scene file, and each field of its
/// components gi, camera and transform that differs from what the file says. Throws Error where a command line
/// cannot say it: there is no camera, no file, or the file lacks the camera.
std::vector<std::string> capture_command(World& world, const ComponentRegistry& registry, uvec2 size);

}  // namespace sl
