// SPDX-License-Identifier: MIT
#pragma once

#include "editor/projection.h"
#include "editor/see/pixel_probe.h"

namespace sl {

/// Over the picture: a cross at the probe's point, and lines to it from the lights and the texels that bring it most.
void draw_probe_lines(const ProbeReading& reading, const Projection& project, float scale);

}  // namespace sl
