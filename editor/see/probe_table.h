// SPDX-License-Identifier: MIT
#pragma once

#include "editor/see/pixel_probe.h"
#include "engine/ecs/world.h"

namespace sl {

/// What a probe has found, as text. Inside a window.
void probe_table(const World& world, const ProbeReading& reading);

}  // namespace sl
