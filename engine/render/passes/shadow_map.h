// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/passes/frame_input.h"

namespace sl {

/// Depth as each light sees it, reversed; a layer per light. A layer is drawn again only when its light, or something
/// that the light sees, has changed.
struct ShadowMaps {
    ImageId sun;   ///< array: directional lights
    ImageId spot;  ///< array: spot lights
};

ShadowMaps shadow_maps(const FrameInput& frame);

}  // namespace sl
