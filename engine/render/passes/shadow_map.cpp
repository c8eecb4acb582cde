// SPDX-License-Identifier: MIT
#include "engine/render/passes/shadow_map.h"

#include <algorithm>

#include "shared/view.h"

namespace sl {

namespace {

ImageId shadow_array(const FrameInput& frame, const char* name, const std::vector<std::uint32_t>& lights) {
    std::uint32_t size = 1;
    for (const std::uint32_t light : lights) size = std::max(size, frame.scene.lights[light].shadow_size);
    const auto layers = static_cast<std::uint32_t>(std::max<std::size_t>(lights.size(), 1));
    ImageId array = frame.graph.persistent(name, {.width = size, .height = size, .layers = layers, .format = Format::depth32f});
    for (std::uint32_t layer = 0; layer < lights.size(); ++layer) {
        const LightMap& map = frame.lights.maps[lights[layer]];
        if (!frame.graph.needs_redraw(array, layer, map.key)) continue;
        auto pass = frame.graph.geometry(fmt::format("{}_{}", name, layer), "passes/shadow_map.vert", "passes/shadow_map.frag");
        pass.params("View", ViewParams{.clip_from_world = map.clip_from_world, .light = {}})
            .storage("Draws", frame.inputs.draws)
            .draws(frame.inputs.list(visible_draws(frame.scene, map.clip_from_world)))
            .two_sided()
            .depth_bias(1.0f);
        array = pass.depth(array, Load::clear, layer);
    }
    return array;
}

}  // namespace

ShadowMaps shadow_maps(const FrameInput& frame) {
    return {.sun = shadow_array(frame, "shadow_sun", frame.lights.sun_layers),
            .spot = shadow_array(frame, "shadow_spot", frame.lights.spot_layers)};
}

}  // namespace sl
