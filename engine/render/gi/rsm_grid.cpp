// SPDX-License-Identifier: MIT
#include "engine/render/gi/sliced.h"

namespace sl {

GiResult indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const RsmGrid& settings) {
    const Rsm maps = rsm(frame, settings.rsm_size);
    if (maps.layers == 0) return {.irradiance = frame.graph.black()};
    const std::uint32_t side = (settings.rsm_size + settings.step - 1) / settings.step;
    SlicedSum sum{.name = "rsm_grid", .fragment = "gi/rsm_grid.frag"};
    sum.params.map = vec4(settings.rsm_size, maps.layers, settings.strength, 1.0f);
    sum.params.grid = vec4(settings.angle_threshold, settings.distance_attenuation, settings.cutoff, settings.step);
    sum.texels = side * side * maps.layers;
    sum.inputs = [&](PassBuilder& pass) { pass.read("rsm_position", maps.position).read("rsm_flux", maps.flux); };
    return sliced_sum(frame, gbuffer, maps, sum);
}

}  // namespace sl
