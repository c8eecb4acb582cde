// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/passes/gbuffer.h"
#include "engine/render/passes/shadow_map.h"

namespace sl {

/// What water is seen with.
struct WaterInput {
    const GBuffer& gbuffer;
    const ShadowMaps& shadows;
    ImageId hdr;
    ImageId irradiance;
};

/// The picture seen through and mirrored in water (nit, rgba32f); `hdr` itself where none is in view.
ImageId water(const FrameInput& frame, const WaterInput& input);

}  // namespace sl
