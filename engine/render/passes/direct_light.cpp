// SPDX-License-Identifier: MIT
#include "engine/render/passes/direct_light.h"

namespace sl {

ImageId direct_light(const FrameInput& frame, const GBuffer& gbuffer, const ShadowMaps& shadows) {
    const bool relief = gbuffer.vertex_normal != gbuffer.normal;
    auto pass = frame.graph.fullscreen("direct_light", relief ? "passes/direct_light_relief.frag" : "passes/direct_light.frag");
    if (relief) pass.read("vertex_normal", gbuffer.vertex_normal);
    pass.params("Frame", frame.params)
        .storage("Lights", frame.inputs.lights)
        .read("depth", gbuffer.depth)
        .read("normal", gbuffer.normal)
        .read("albedo", gbuffer.albedo)
        .read("material", gbuffer.material)
        .read("emission", gbuffer.emission)
        .read("shadow_sun", shadows.sun, Sampling::shadow_compare)
        .read("shadow_spot", shadows.spot, Sampling::shadow_compare)
        .read("shadow_point", shadows.point, Sampling::shadow_compare);
    return pass.create("direct", frame.screen(Format::rgba32f));
}

}  // namespace sl
