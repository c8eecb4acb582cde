// SPDX-License-Identifier: MIT
#include <algorithm>

#include "engine/render/gi/gi.h"
#include "shared/rsm.h"
#include "shared/view.h"

namespace sl {

namespace {

struct Gather {
    const FrameInput& frame;
    const GBuffer& gbuffer;
    RsmGatherParams params{};
    BufferId texels;

    /// What every pass that gathers reads.
    void inputs(PassBuilder& pass) const {
        pass.params("Frame", frame.params)
            .params("Gather", params)
            .storage("Lights", frame.inputs.lights)
            .storage("Texels", texels)
            .read("depth", gbuffer.depth)
            .read("normal", gbuffer.normal);
    }
};

BufferId packed_texels(const FrameInput& frame, const Rsm& maps) {
    const std::uint32_t texels = maps.size * maps.size * maps.layers;
    BufferId packed = frame.graph.persistent_buffer("rsm_disc_texels", texels * sizeof(RsmPackedTexel));
    if (!frame.graph.needs_redraw(packed, 0, maps.key)) return packed;
    auto pass = frame.graph.compute("rsm_disc_texels", "gi/rsm_disc_texels.comp");
    pass.read("rsm_position", maps.position).read("rsm_flux", maps.flux).dispatch_items(texels, 64);
    return pass.write_storage("Texels", packed);
}

ImageId gather_everywhere(const Gather& gather) {
    auto pass = gather.frame.graph.fullscreen("rsm_disc", "gi/rsm_disc.frag");
    gather.inputs(pass);
    return pass.create("irradiance", gather.frame.screen(Format::rgba32f));
}

ImageId gather_low(const Gather& gather, std::uint32_t spacing) {
    FrameGraph& graph = gather.frame.graph;
    auto pass = graph.fullscreen("rsm_disc_low", "gi/rsm_disc.frag");
    gather.inputs(pass);
    const TextureDesc desc{.width = (gather.frame.width + spacing - 1) / spacing, .height = (gather.frame.height + spacing - 1) / spacing, .format = Format::rgba32f};
    return pass.write("irradiance", graph.create("irradiance_low", desc), Load::discard);
}

struct Filled {
    ImageId irradiance, refined;
};

/// Interpolates where neighbours agree, and marks where they don't.
Filled fill(const Gather& gather, ImageId low) {
    auto pass = gather.frame.graph.fullscreen("rsm_disc_fill", "gi/rsm_disc_fill.frag");
    pass.params("Frame", gather.frame.params)
        .params("Gather", gather.params)
        .read("depth", gather.gbuffer.depth)
        .read("normal", gather.gbuffer.normal)
        .read("irradiance_low", low);
    const ImageId irradiance = pass.create("irradiance", gather.frame.screen(Format::rgba32f));
    return {irradiance, pass.create("refined", gather.frame.screen(Format::rgba8))};
}

/// Gathers at the marked pixels alone. They are listed row by row first, so that a processor that works on many pixels
/// at once finds them side by side; one list per row needs no counter that all share.
ImageId refine(const Gather& gather, const Filled& filled) {
    FrameGraph& graph = gather.frame.graph;
    const std::uint32_t rows = gather.frame.height;
    auto list = graph.compute("rsm_disc_list", "gi/rsm_disc_list.comp");
    list.read("refined", filled.refined).dispatch((rows + 63) / 64);
    const BufferId pixels = list.write_storage("Pixels", graph.create_buffer("rsm_disc_pixels", std::uint64_t{rows} * (gather.frame.width + 1) * sizeof(std::uint32_t)));
    auto pass = graph.compute("rsm_disc_refine", "gi/rsm_disc_refine.comp");
    gather.inputs(pass);
    pass.storage("Pixels", pixels).dispatch(rows);
    return pass.store("irradiance", filled.irradiance);
}

}  // namespace

GiResult indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const RsmDisc& settings) {
    const Rsm maps = rsm(frame, settings.rsm_size);
    if (maps.layers == 0 || settings.samples == 0) return {.irradiance = frame.graph.black()};
    Gather gather{.frame = frame, .gbuffer = gbuffer, .texels = packed_texels(frame, maps)};
    gather.params.map = vec4(settings.rsm_size, maps.layers, settings.strength, 1.0f);
    const std::uint32_t spacing = settings.interpolate ? settings.low_resolution : 1;
    gather.params.disc = vec4(settings.samples, settings.radius, settings.rotate ? 1 : 0, spacing);
    gather.params.tolerance = vec4(settings.position_tolerance, settings.normal_tolerance, 0, 0);
    if (!settings.interpolate) return {.irradiance = gather_everywhere(gather)};
    return {.irradiance = refine(gather, fill(gather, gather_low(gather, spacing)))};
}

}  // namespace sl
