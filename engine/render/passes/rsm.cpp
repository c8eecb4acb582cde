// SPDX-License-Identifier: MIT
#include "engine/render/passes/rsm.h"

#include "shared/view.h"

namespace sl {

Rsm rsm(const FrameInput& frame, std::uint32_t size) {
    FrameGraph& graph = frame.graph;
    Rsm result;
    result.size = size;
    result.layers = static_cast<std::uint32_t>(frame.lights.rsm_layers.size());
    if (result.layers == 0) return result;
    const TextureDesc desc{.width = size, .height = size, .layers = result.layers, .format = Format::rgba32f};
    result.position = graph.persistent("rsm_position", desc);
    result.flux = graph.persistent("rsm_flux", desc);
    ImageId depth = graph.create("rsm_depth", {.width = size, .height = size, .format = Format::depth32f});
    for (std::uint32_t layer = 0; layer < result.layers; ++layer) {
        const std::uint32_t light = frame.lights.rsm_layers[layer];
        const LightMap& map = frame.lights.maps[light];
        result.key = hash_mix(result.key, map.key);
        // Both images are drawn by one pass, so one of the two keys decides for both.
        const bool stale = graph.needs_redraw(result.position, layer, map.key);
        if (!stale) continue;
        auto pass = graph.geometry(fmt::format("rsm_{}", layer), "passes/rsm.vert", "passes/rsm.frag");
        pass.params("View", ViewParams{.clip_from_world = map.clip_from_world, .light = uvec4(light, size, 0, 0)})
            .storage("Draws", frame.inputs.draws)
            .storage("Materials", frame.inputs.materials)
            .storage("Lights", frame.inputs.lights)
            .read("block_textures", frame.inputs.textures, Sampling::pixel_art)
            .draws(frame.inputs.list(visible_draws(frame.scene, map.clip_from_world)));
        result.position = pass.write("rsm_position", result.position, Load::clear, layer);
        result.flux = pass.write("rsm_flux", result.flux, Load::clear, layer);
        depth = pass.depth(depth, Load::clear);
    }
    return result;
}

}  // namespace sl
