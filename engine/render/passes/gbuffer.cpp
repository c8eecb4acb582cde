// SPDX-License-Identifier: MIT
#include "engine/render/passes/gbuffer.h"

#include <algorithm>

#include "shared/view.h"

namespace sl {

namespace {

/// What the camera sees, nearest first: what lies behind is not shaded then.
std::vector<std::uint32_t> seen_draws(const FrameInput& frame) {
    std::vector<std::uint32_t> draws = visible_draws(frame.scene, frame.params.clip_from_world);
    const vec3 eye = vec3(frame.params.camera_position);
    const auto away = [&](std::uint32_t draw) {
        const Bounds& box = frame.scene.draws[draw].bounds;
        const vec3 nearest = glm::clamp(eye, box.low, box.high) - eye;
        return glm::dot(nearest, nearest);
    };
    std::ranges::stable_sort(draws, {}, away);
    return draws;
}

}  // namespace

GBuffer gbuffer(const FrameInput& frame) {
    auto pass = frame.graph.geometry("gbuffer", "passes/gbuffer.vert", "passes/gbuffer.frag");
    pass.params("View", ViewParams{.clip_from_world = frame.params.clip_from_world, .light = {}})
        .storage("Draws", frame.inputs.draws)
        .storage("Materials", frame.inputs.materials)
        .read("block_textures", frame.inputs.textures, Sampling::pixel_art)
        .draws(frame.inputs.list_facing(seen_draws(frame), vec4(vec3(frame.params.camera_position), 1.0f)));
    GBuffer result;
    result.albedo = pass.create("albedo", frame.screen(Format::srgb8_alpha8), Load::clear);
    result.normal = pass.create("normal", frame.screen(Format::rg16), Load::clear, {0.5f, 0.5f, 0, 0});
    result.material = pass.create("material", frame.screen(Format::rgba8), Load::clear);
    result.emission = pass.create("emission", frame.screen(Format::rgba16f), Load::clear);
    result.depth = pass.depth(frame.graph.create("depth", frame.screen(Format::depth32f)), Load::clear);
    return result;
}

}  // namespace sl
