// SPDX-License-Identifier: MIT
#include "engine/render/passes/direct_light.h"

namespace sl {

ImageId direct_light(const FrameInput& frame, const GBuffer& gbuffer, const ShadowMaps& shadows) {
    auto pass = frame.graph.fullscreen("direct_light", "passes/direct_light.frag");
    pass.params("Frame", frame.params)
        .storage("Lights", frame.inputs.lights)
        .read("depth", gbuffer.depth)
        .read("normal", gbuffer.normal)
        .read("albedo", gbuffer.albedo)
        .read("material", gbuffer.material)
        .read("emission", gbuffer.emission)
        .read("shadow_sun", shadows.sun, Sampling::shadow_compare)
        .read("shadow_spot", shadows.spot, Sampling::shadow_compare);
    return pass.create("direct", frame.screen(Format::rgba32f));
}

}  // namespace sl
