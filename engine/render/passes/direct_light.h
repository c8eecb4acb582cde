// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/passes/gbuffer.h"
#include "engine/render/passes/shadow_map.h"

namespace sl {

/// Radiance (nit, rgba32f) from lights that shine straight on what the camera sees, and from what glows by itself.
ImageId direct_light(const FrameInput& frame, const GBuffer& gbuffer, const ShadowMaps& shadows);

}  // namespace sl
