// SPDX-License-Identifier: MIT
#include "engine/render/passes/gbuffer.h"

#include "shared/view.h"

namespace sl {

GBuffer gbuffer(const FrameInput& frame) {
    const std::vector<std::uint32_t> visible = visible_draws(frame.scene, frame.params.clip_from_world);
    auto pass = frame.graph.geometry("gbuffer", "passes/gbuffer.vert", "passes/gbuffer.frag");
    pass.params("View", ViewParams{.clip_from_world = frame.params.clip_from_world, .light = {}})
        .storage("Draws", frame.inputs.draws)
        .storage("Materials", frame.inputs.materials)
        .read("block_textures", frame.inputs.textures, Sampling::pixel_art)
        .draws(frame.inputs.list(visible));
    GBuffer result;
    result.albedo = pass.create("albedo", frame.screen(Format::srgb8_alpha8), Load::clear);
    result.normal = pass.create("normal", frame.screen(Format::rg16), Load::clear, {0.5f, 0.5f, 0, 0});
    result.material = pass.create("material", frame.screen(Format::rgba8), Load::clear);
    result.emission = pass.create("emission", frame.screen(Format::rgba16f), Load::clear);
    result.depth = pass.depth(frame.graph.create("depth", frame.screen(Format::depth32f)), Load::clear);
    return result;
}

}  // namespace sl
