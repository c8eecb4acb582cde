// SPDX-License-Identifier: MIT
#include "engine/render/passes/gbuffer.h"

#include <algorithm>

#include "engine/render/passes/pictured_draws.h"
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
    const vec4 eye(vec3(frame.params.camera_position), 1.0f);
    const ViewParams view{.clip_from_world = frame.params.clip_from_world, .light = {}};
    const ByPictures draws = by_pictures(frame.scene, seen_draws(frame));
    auto pass = frame.graph.geometry("gbuffer", "passes/gbuffer.vert", "passes/gbuffer.frag");
    pass.params("View", view)
        .storage("Draws", frame.inputs.draws)
        .storage("Materials", frame.inputs.materials)
        .read("block_textures", frame.inputs.textures, Sampling::pixel_art)
        .draws(frame.inputs.list_facing(draws.plain, eye));
    GBuffer result;
    result.albedo = pass.create("albedo", frame.screen(Format::srgb8_alpha8), Load::clear);
    result.normal = pass.create("normal", frame.screen(Format::rg16), Load::clear, {0.5f, 0.5f, 0, 0});
    result.material = pass.create("material", frame.screen(Format::rgba8), Load::clear);
    result.emission = pass.create("emission", frame.screen(Format::rgba16f), Load::clear);
    result.depth = pass.depth(frame.graph.create("depth", frame.screen(Format::depth32f)), Load::clear);
    const auto draw_into = [&](PassBuilder& pictured, const std::vector<std::uint32_t>& numbers) {
        read_pictures(pictured.params("View", view).draws(frame.inputs.list_facing(numbers, eye)), frame.inputs);
        result.albedo = pictured.write("albedo", result.albedo, Load::keep);
        result.normal = pictured.write("normal", result.normal, Load::keep);
        result.material = pictured.write("material", result.material, Load::keep);
        result.emission = pictured.write("emission", result.emission, Load::keep);
    };
    if (!draws.together.empty()) {
        auto pictured = frame.graph.geometry("gbuffer_pictures", "passes/pictured.vert", "passes/gbuffer_pictures.frag");
        draw_into(pictured, draws.together);
        result.depth = pictured.depth(result.depth, Load::keep);
    }
    result.vertex_normal = result.normal;
    if (draws.apart.empty()) return result;
    auto copy = frame.graph.fullscreen("vertex_normal", "passes/copy_normal.frag");
    copy.read("normal", result.normal);
    const ImageId vertex_normal = copy.create("vertex_normal", frame.screen(Format::rg16));
    auto pictured = frame.graph.geometry("gbuffer_pictures_apart", "passes/pictured_apart.vert", "passes/gbuffer_pictures_apart.frag");
    draw_into(pictured, draws.apart);
    result.vertex_normal = pictured.write("vertex_normal", vertex_normal, Load::keep);
    result.depth = pictured.depth(result.depth, Load::keep);
    return result;
}

}  // namespace sl
