// SPDX-License-Identifier: MIT
#include "engine/render/gi/sliced.h"
#include "shared/rsm.h"

namespace sl {

namespace {

/// All texels of all layers as one array, layer after layer, so that every pixel walks the same memory in order.
BufferId texel_array(const FrameInput& frame, const Rsm& rsm) {
    const std::uint32_t texels = rsm.size * rsm.size * rsm.layers;
    BufferId array = frame.graph.persistent_buffer("rsm_texels", texels * sizeof(RsmTexel));
    if (!frame.graph.needs_redraw(array, 0, rsm.key)) return array;
    auto pass = frame.graph.compute("rsm_texels", "gi/rsm_texels.comp");
    pass.read("rsm_position", rsm.position).read("rsm_flux", rsm.flux).dispatch_items(texels, 64);
    return pass.write_storage("Texels", array);
}

}  // namespace

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
