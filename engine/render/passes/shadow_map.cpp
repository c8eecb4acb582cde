// SPDX-License-Identifier: MIT
#include "engine/render/passes/shadow_map.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "engine/render/passes/pictured_draws.h"
#include "engine/render/scene/point_map.h"
#include "shared/view.h"

namespace sl {

namespace {

/// Triangles of tiles that may wait, drawn in a frame of a game, and one tile more; each tile stands for many changes then.
constexpr std::uint64_t enough = 6000;
/// At least one such tile in so many frames.
constexpr std::uint64_t frames_of_a_turn = 4;

std::uint64_t triangles_of(const FrameInput& frame, const ShadowLayer& map) {
    std::uint64_t triangles = 0;
    for (const std::uint32_t draw : map.draws) triangles += frame.inputs.calls[draw].index_count / 3;
    return triangles;
}

/// What is drawn into each layer of an array of shadow maps in this frame.
class Turns {
  public:
    enum class Turn { none, empty, whole };

    Turns(const FrameInput& frame, ImageId array, const std::vector<ShadowLayer>& layers) : frame_(frame), array_(array), layers_(layers) {
        const auto moved = std::ranges::count_if(indices(), [&](std::uint32_t layer) { return elsewhere(layer); });
        // A picture waits for all, and under another sun nothing that was drawn is of use.
        waiting_ = frame.slice_budget != ~0u && 2 * static_cast<std::size_t>(moved) < layers.size();
        if (!waiting_ || layers.empty()) return;
        // Each has its turn, however often others change.
        const auto all = static_cast<std::uint32_t>(layers.size()), first = frame.params.counts.y * 2 % all;
        std::uint64_t triangles = 0;
        for (std::uint32_t i = 0; i < all && triangles < enough; ++i) {
            const std::uint32_t layer = (first + i) % all;
            if (!layers[layer].may_wait || !stale(layer)) continue;
            drawn_.push_back(layer);
            triangles += triangles_of(frame, layers[layer]);
        }
    }
    Turn of(std::uint32_t layer) const {
        if (!layers_[layer].in_view || !stale(layer)) return Turn::none;
        if (!waiting_ || !layers_[layer].may_wait || std::ranges::find(drawn_, layer) != drawn_.end()) return Turn::whole;
        // What was there is shown until it has its turn, but not somewhere else.
        return elsewhere(layer) ? Turn::empty : Turn::none;
    }

  private:
    std::uint64_t drawn(std::uint32_t layer) const { return frame_.graph.drawn_key(array_, layer); }
    bool stale(std::uint32_t layer) const { return drawn(layer) != layers_[layer].key; }
    bool elsewhere(std::uint32_t layer) const { return drawn(layer) >> 32 != layers_[layer].key >> 32; }
    std::vector<std::uint32_t> indices() const {
        std::vector<std::uint32_t> all(layers_.size());
        std::iota(all.begin(), all.end(), 0u);
        return all;
    }

    const FrameInput& frame_;
    ImageId array_;
    const std::vector<ShadowLayer>& layers_;
    bool waiting_ = false;
    std::vector<std::uint32_t> drawn_;
};

ImageId shadow_array(const FrameInput& frame, const char* name, const std::vector<ShadowLayer>& layers) {
    std::uint32_t size = 1;
    for (const ShadowLayer& layer : layers) size = std::max(size, layer.size);
    const auto count = static_cast<std::uint32_t>(std::max<std::size_t>(layers.size(), 1));
    return frame.graph.persistent(name, {.width = size, .height = size, .layers = count, .format = Format::depth32f});
}

DrawList calls_of(const FrameInput& frame, const ShadowLayer& map, const std::vector<std::uint32_t>& draws) {
    return map.from == vec3(0.0f) ? frame.inputs.list(draws) : frame.inputs.list_facing(draws, vec4(map.from, 0.0f));
}

/// Draws a layer anew, or empties it; returns the array with it.
ImageId draw_layer(const FrameInput& frame, const char* name, ImageId array, std::uint32_t layer, const ShadowLayer& map, bool whole) {
    if (!frame.graph.needs_redraw(array, layer, whole ? map.key : map.empty_key())) return array;
    std::vector<std::uint32_t> solid, open;
    for (const std::uint32_t draw : map.draws) (frame.scene.draws[draw].open ? open : solid).push_back(draw);
    const ViewParams view{.clip_from_world = map.clip_from_world, .light = {}};
    auto pass = frame.graph.geometry(fmt::format("{}_{}", name, layer), "passes/shadow_map.vert", "passes/shadow_map.frag");
    pass.params("View", view)
        .storage("Draws", frame.inputs.draws)
        .draws(whole ? calls_of(frame, map, solid) : nullptr)
        .two_sided()
        .depth_bias(1.0f);
    array = pass.depth(array, Load::clear, layer);
    if (!whole || open.empty()) return array;
    auto pictured = frame.graph.geometry(fmt::format("{}_pictures_{}", name, layer), "passes/pictured.vert", "passes/shadow_map_pictures.frag");
    read_picture_colours(pictured.params("View", view).draws(calls_of(frame, map, open)).two_sided().depth_bias(1.0f), frame.inputs);
    return pictured.depth(array, Load::keep, layer);
}

struct DrawnArray {
    ImageId image;
    std::uint64_t triangles = 0;  ///< that this frame draws into it
};

DrawnArray drawn_array(const FrameInput& frame, const char* name, const std::vector<ShadowLayer>& layers) {
    std::uint64_t triangles = 0;
    ImageId array = shadow_array(frame, name, layers);
    const Turns turns(frame, array, layers);
    for (std::uint32_t layer = 0; layer < layers.size(); ++layer) {
        const Turns::Turn turn = turns.of(layer);
        if (turn != Turns::Turn::none) array = draw_layer(frame, name, array, layer, layers[layer], turn == Turns::Turn::whole);
        if (turn == Turns::Turn::whole) triangles += triangles_of(frame, layers[layer]);
    }
    return {array, triangles};
}

std::vector<ShadowLayer> point_layers(const FrameInput& frame) {
    std::vector<ShadowLayer> layers;
    for (const std::uint32_t light : frame.lights.point_maps) std::ranges::move(point_faces(frame.scene, frame.scene.lights[light], frame.params), std::back_inserter(layers));
    return layers;
}

/// Some more layers of the array that suns are about to move to, up to about so many triangles; returns whether none is left.
bool draw_next(const FrameInput& frame, const char* name, const std::vector<ShadowLayer>& layers, std::uint64_t most) {
    ImageId array = shadow_array(frame, name, layers);
    std::uint64_t triangles = 0;
    bool all = true;
    for (std::uint32_t layer = 0; layer < layers.size(); ++layer) {
        // What changes there once it is drawn, is drawn when the array is in use.
        if (frame.graph.drawn_key(array, layer) >> 32 == layers[layer].key >> 32) continue;
        all = triangles < most;
        if (!all) break;
        array = draw_layer(frame, name, array, layer, layers[layer], true);
        triangles += triangles_of(frame, layers[layer]);
    }
    frame.graph.want(array);
    return all;
}

constexpr std::array sun_arrays{"shadow_sun", "shadow_sun_other"};

}  // namespace

ShadowMaps shadow_maps(const FrameInput& frame) {
    const LightTable& lights = frame.lights;
    const DrawnArray sun = drawn_array(frame, sun_arrays[lights.sun_array], lights.sun_layers), spot = drawn_array(frame, "shadow_spot", lights.spot_layers);
    ShadowMaps maps{.sun = sun.image, .spot = spot.image, .point = drawn_array(frame, "shadow_point", point_layers(frame)).image};
    if (lights.next_sun_layers.empty()) return maps;
    // What is shown goes first, but where that changes in each frame the sun must go on too.
    const bool turn = frame.params.counts.y % frames_of_a_turn == 0;
    const std::uint64_t most = enough - std::min(sun.triangles, enough);
    maps.next_is_drawn = draw_next(frame, sun_arrays[1 - lights.sun_array], lights.next_sun_layers, turn ? std::max(most, std::uint64_t{1}) : most);
    return maps;
}

}  // namespace sl
