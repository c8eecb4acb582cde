// SPDX-License-Identifier: MIT
#include "engine/render/frame.h"

#include "engine/render/passes/compose.h"
#include "engine/render/passes/direct_light.h"
#include "engine/render/passes/water.h"

namespace sl {

FrameOutput build_frame(const FrameInput& frame, std::span<const PicturePass> added) {
    FrameOutput output;
    output.gbuffer = gbuffer(frame);
    const ShadowMaps shadows = shadow_maps(frame);
    output.next_suns_are_drawn = shadows.next_is_drawn;
    output.direct = direct_light(frame, output.gbuffer, shadows);

    frame.graph.group(gi_group);
    const GiResult gi = run_gi_method(frame, output.gbuffer, frame.scene.gi ? frame.scene.gi->method : GiOff{});
    frame.graph.group({});
    output.irradiance = gi.irradiance;
    output.gi_progress = gi.progress;
    output.gi_traced_seconds = gi.traced_seconds;
    output.gi_error = gi.error;

    output.hdr = compose(frame, output.gbuffer, output.direct, output.irradiance);
    ImageId seen = water(frame, {.gbuffer = output.gbuffer, .shadows = shadows, .hdr = output.hdr, .irradiance = output.irradiance});
    for (const PicturePass& pass : added) seen = pass(frame, output, seen);
    const ImageId ldr = tonemap(frame, seen);
    output.final = frame.scene.view->antialias ? antialias(frame, ldr) : ldr;
    return output;
}

}  // namespace sl
