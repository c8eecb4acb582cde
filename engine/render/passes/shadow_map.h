// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/passes/frame_input.h"

namespace sl {

/// Depth as each light sees it, reversed; a layer per spot light, six per point light. A layer is drawn again only when its light,
/// or something that the light sees, has changed.
struct ShadowMaps {
    ImageId sun;   ///< array: directional lights
    ImageId spot;  ///< array: spot lights
    ImageId point; ///< array: point lights, six layers each
    bool next_is_drawn = false;  ///< the array that suns are about to move to has all of its layers
};

/// Adds passes for the layers that are out of date.
ShadowMaps shadow_maps(const FrameInput& frame);

}  // namespace sl
