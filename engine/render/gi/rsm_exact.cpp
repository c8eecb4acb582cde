// SPDX-License-Identifier: MIT
#include "engine/render/gi/sliced.h"

namespace sl {

GiResult indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const RsmExact& settings) {
    const Rsm maps = rsm(frame, settings.rsm_size);
    if (maps.layers == 0) return {.irradiance = frame.graph.black()};
    const BufferId texels = texel_array(frame, maps);
    SlicedSum sum{.name = "rsm_exact", .fragment = "gi/rsm_exact.frag", .finish = "gi/rsm_exact_near.frag"};
    sum.params.map = vec4(settings.rsm_size, maps.layers, settings.strength, 1.0f);
    sum.texels = settings.rsm_size * settings.rsm_size * maps.layers;
    sum.inputs = [&](PassBuilder& pass) { pass.storage("Texels", texels); };
    sum.finish_inputs = [&](PassBuilder& pass) { pass.storage("Lights", frame.inputs.lights); };
    return sliced_sum(frame, gbuffer, maps, sum);
}

}  // namespace sl
