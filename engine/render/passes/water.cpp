// SPDX-License-Identifier: MIT
#include "engine/render/passes/water.h"

#include <cmath>
#include <numeric>

#include "shared/view.h"
#include "shared/water.h"

namespace sl {

namespace {

/// A clear lake, 1/m at 610, 550 and 465 nm: pure water (Pope & Fry 1997: 0.264, 0.057, 0.010) and a little of what lives in it.
constexpr vec3 absorption{0.3f, 0.075f, 0.05f};
/// Share of what falls on deep clear water that comes back, at the same wavelengths (Morel & Prieur 1977: one to three percent
/// in the blue and green).
constexpr vec3 scattering{0.002f, 0.012f, 0.02f};
/// Ripples repeat after this, s.
constexpr double ripple_period = 60.0;

struct WaterSurfaces {
    ImageId normal, depth;
};

WaterSurfaces water_surfaces(const FrameInput& frame, const std::vector<std::uint32_t>& visible) {
    auto pass = frame.graph.geometry("water_surface", "passes/water_surface.vert", "passes/water_surface.frag");
    pass.params("View", ViewParams{.clip_from_world = frame.params.clip_from_world, .light = {}})
        .storage("Draws", frame.inputs.draws)
        .draws(frame.inputs.water_list(visible))
        .two_sided();
    WaterSurfaces result;
    result.normal = pass.create("water_normal", frame.screen(Format::rg16), Load::clear, {0.5f, 0.5f, 0, 0});
    result.depth = pass.depth(frame.graph.create("water_depth", frame.screen(Format::depth32f)), Load::clear);
    return result;
}

WaterParams water_params(const FrameInput& frame) {
    const bool knows_sky = frame.scene.gi && frame.scene.gi->method.is<Facets>();
    const float pixel = 2.0f * glm::length(vec3(frame.params.ray_up)) / frame.params.ray_up.w;
    WaterParams params{};
    params.absorption = vec4(absorption, static_cast<float>(std::fmod(frame.time, ripple_period)));
    params.scattering = vec4(scattering, 0.0f);
    params.view = vec4(frame.scene.view->in_water ? 1.0f : 0.0f, knows_sky ? 1.0f : 0.0f, pixel, 0.0f);
    return params;
}

void read_all(PassBuilder& pass, const FrameInput& frame, const WaterInput& input) {
    pass.params("Frame", frame.params)
        .params("Water", water_params(frame))
        .storage("Lights", frame.inputs.lights)
        .read("hdr", input.hdr)
        .read("depth", input.gbuffer.depth)
        .read("irradiance", input.irradiance)
        .read("shadow_sun", input.shadows.sun, Sampling::shadow_compare);
}

/// The picture without any water's surface.
ImageId around(const FrameInput& frame, const WaterInput& input) {
    const bool below = frame.scene.view->in_water;
    auto pass = frame.graph.fullscreen("water_around", below ? "passes/water_below.frag" : "passes/water_above.frag");
    below ? read_all(pass, frame, input) : void(pass.read("hdr", input.hdr));
    return pass.create("hdr_water", frame.screen(Format::rgba32f));
}

/// What is in view. In a window's first frame all, wherever it is: the driver takes a quarter of a second for these programs,
/// which is less noticed there than where the first lake comes into view.
std::vector<std::uint32_t> waters_drawn(const FrameInput& frame) {
    const bool opens = frame.graph.states().frame == 0 && frame.slice_budget != ~0u;
    if (!opens) return visible_draws(frame.scene.waters, frame.params.clip_from_world);
    std::vector<std::uint32_t> all(frame.scene.waters.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
}

}  // namespace

ImageId water(const FrameInput& frame, const WaterInput& input) {
    const std::vector<std::uint32_t> visible = waters_drawn(frame);
    if (visible.empty() && !frame.scene.view->in_water) return input.hdr;
    const ImageId picture = around(frame, input);
    if (visible.empty()) return picture;
    // Where water is seen alone: a search of the screen costs much.
    const WaterSurfaces surfaces = water_surfaces(frame, visible);
    auto pass = frame.graph.geometry("water", "passes/water_surface.vert", "passes/water.frag");
    read_all(pass, frame, input);
    pass.params("View", ViewParams{.clip_from_world = frame.params.clip_from_world, .light = {}})
        .storage("Draws", frame.inputs.draws)
        .read("water_depth", surfaces.depth)
        .read("water_normal", surfaces.normal)
        .draws(frame.inputs.water_list(visible))
        .two_sided();
    return pass.write("hdr_water", picture, Load::keep);
}

}  // namespace sl
