// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/renderer.h"
#include "engine/render/trace/light_meter.h"

namespace sl {

/// A frame that was just drawn, and what else tells of its light.
struct SeenFrame {
    const RenderScene& scene;
    const Renderer& renderer;
    const Renderer::Result& result;
    uvec2 size{0};
    double seconds = 0.0;  ///< since the last one
    LightMeter* meter = nullptr;

    FrameParams params() const { return frame_params(scene, size.x, size.y, 0); }
};

}  // namespace sl
