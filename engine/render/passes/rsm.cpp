// SPDX-License-Identifier: MIT
#include "engine/render/passes/rsm.h"

#include "engine/core/error.h"

#include "engine/render/passes/pictured_draws.h"
#include "shared/view.h"

namespace sl {

namespace {

constexpr std::uint32_t most_layers = 2048;  ///< of an array texture, in every OpenGL 4.5
constexpr std::uint64_t most_texels = std::uint64_t{1} << 26;  ///< 2 GiB of two images

/// Where a light shines from, in homogeneous coordinates.
vec4 eye_of(const RenderScene::Light& light) {
    return light.kind == RenderScene::Light::Kind::directional ? vec4(-light.direction, 0.0f) : vec4(light.position, 1.0f);
}

}  // namespace

Rsm rsm(const FrameInput& frame, std::uint32_t size) {
    FrameGraph& graph = frame.graph;
    Rsm result;
    result.size = size;
    result.layers = static_cast<std::uint32_t>(frame.lights.rsm_layers.size());
    if (result.layers == 0) return result;
    const std::uint64_t texels = std::uint64_t{size} * size * result.layers;
    if (result.layers > most_layers || texels > most_texels) {
        fail("{} lights bounce, with maps of {} x {} texels: that is more than the {} layers and {} million texels that fit; lower gi.rsm_size, or switch off 'bounces' on lights",
             result.layers, size, size, most_layers, most_texels >> 20);
    }
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
        const ViewParams view{.clip_from_world = map.clip_from_world, .light = uvec4(light, size, 0, 0)};
        const vec4 eye = eye_of(frame.scene.lights[light]);
        const ByPictures draws = by_pictures(frame.scene, visible_draws(frame.scene, map.clip_from_world));
        auto pass = graph.geometry(fmt::format("rsm_{}", layer), "passes/rsm.vert", "passes/rsm.frag");
        pass.params("View", view)
            .storage("Draws", frame.inputs.draws)
            .storage("Materials", frame.inputs.materials)
            .storage("Lights", frame.inputs.lights)
            .read("block_textures", frame.inputs.textures, Sampling::pixel_art)
            .draws(frame.inputs.list_facing(draws.plain, eye));
        result.position = pass.write("rsm_position", result.position, Load::clear, layer);
        result.flux = pass.write("rsm_flux", result.flux, Load::clear, layer);
        depth = pass.depth(depth, Load::clear);
        const auto draw_into = [&](PassBuilder pictured, const std::vector<std::uint32_t>& numbers) {
            read_pictures(pictured.params("View", view).storage("Lights", frame.inputs.lights).draws(frame.inputs.list_facing(numbers, eye)), frame.inputs);
            result.position = pictured.write("rsm_position", result.position, Load::keep, layer);
            result.flux = pictured.write("rsm_flux", result.flux, Load::keep, layer);
            depth = pictured.depth(depth, Load::keep);
        };
        if (!draws.together.empty())
            draw_into(graph.geometry(fmt::format("rsm_pictures_{}", layer), "passes/pictured.vert", "passes/rsm_pictures.frag"), draws.together);
        if (!draws.apart.empty())
            draw_into(graph.geometry(fmt::format("rsm_pictures_apart_{}", layer), "passes/pictured_apart.vert", "passes/rsm_pictures_apart.frag"), draws.apart);
    }
    return result;
}

}  // namespace sl
