// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/passes/gbuffer.h"
#include "engine/render/passes/rsm.h"

namespace sl {

/// What a GI method gives back: diffuse irradiance (lux, before albedo) in the units of direct light.
struct GiResult {
    ImageId irradiance;  ///< rgba32f at the G-buffer's size, or a black pixel
    /// Share of work done where it is spread over frames (1 = finished).
    float progress = 1.0f;
    /// Spent on the CPU's own light transport, s.
    double traced_seconds = 0.0;
    /// Standard error that sampling leaves, over the irradiance; unknown where a method does not say.
    std::optional<float> error;
};

/// The contract: the frame and its settings in, irradiance out. One overload per method, each in gi/<name>.cpp.
GiResult indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const GiOff& settings);
GiResult indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const RsmExact& settings);
GiResult indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const RsmGrid& settings);
GiResult indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const RsmDisc& settings);
GiResult indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const Facets& settings);

}  // namespace sl
