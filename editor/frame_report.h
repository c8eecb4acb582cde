// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/renderer.h"

namespace sl {

/// A pass of the frame as it was compiled.
struct PassReport {
    std::string name;
    bool indirect = false;  ///< the GI method asked for it
    std::string reads, writes;
    std::size_t draws = 0;
    std::uint64_t triangles = 0;
    std::optional<double> milliseconds;  ///< unknown while the timers have not seen it
};

/// What the panel says about a frame: plain data, so that it can be shown without a driver.
struct FrameReport {
    bool drawn = false;
    uvec2 size{0};
    std::vector<PassReport> passes;
    std::vector<gl::SpanTime> times;  ///< of the newest frame that is timed, summed by kind of pass
    std::uint64_t triangles_drawn = 0, triangles_culled = 0;
    std::size_t lights_without_maps = 0;  ///< for which there is no memory
    std::uint64_t mesh_bytes = 0, texture_bytes = 0;
    double traced_milliseconds = 0.0;  ///< of the processor, on light
    std::optional<float> noise;        ///< standard error of indirect light, over its irradiance
    float progress = 1.0f;
    std::optional<double> refined;  ///< share of pixels gathered in full
};

/// Name of what the processor spends on light, among times of passes.
inline constexpr const char* tracing_name = "tracing (processor)";

FrameReport frame_report(Renderer& renderer, const Renderer::Result& frame);

}  // namespace sl
