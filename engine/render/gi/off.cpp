// SPDX-License-Identifier: MIT
#include "engine/render/gi/gi.h"

namespace sl {

GiResult indirect_light(const FrameInput& frame, const GBuffer&, const GiOff&) { return {.irradiance = frame.graph.black()}; }

}  // namespace sl
