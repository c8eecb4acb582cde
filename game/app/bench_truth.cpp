// SPDX-License-Identifier: MIT
#include "game/app/bench_truth.h"

#include <algorithm>

#include "engine/core/error.h"
#include "engine/render/displayable.h"
#include "engine/render/passes/exposure.h"
#include "engine/render/reference/reference.h"
#include "engine/render/reference/reference_file.h"
#include "engine/render/scene/extract.h"

namespace sl {

namespace {

/// A truth's film, from its file as far as that goes.
Film film_of(const RenderScene& scene, const std::string& name, uvec2 size, const TransportSettings& transport, std::uint32_t spp,
             const std::filesystem::path& file, const std::function<void(double)>& tell) {
    const PathTracer tracer(scene, size, transport);
    const ReferenceInfo info{.scene = name, .content = tracer.content_hash(), .size = size, .transport = transport};
    Film film(size);
    if (std::filesystem::exists(file)) {
        try {
            ReferenceFile known = read_reference(file);
            ReferenceInfo::check_same(known.info, file.string(), info, "this view");
            film = std::move(known.film);
        } catch (const Error&) {
            // Of another state of the scene, or damaged: it is made anew.
        }
    }
    const auto progress = trace_reference(
        tracer, film, {.block = {.high = size, .last = spp}},
        [&](const ReferenceProgress& now) {
            tell(now.share);
            return true;
        },
        [&] { write_reference(file, info, film); });
    (void)progress;
    return film;
}

const Image& layer_of(const std::vector<ImageLayer>& layers, std::string_view name) { return std::ranges::find(layers, name, &ImageLayer::name)->image; }

/// Only the lights' part where `lights_only`: the sky and glowing surfaces are no reflective shadow map's business.
Truth truth_of(const Film& film, bool lights_only, std::vector<float>& mask) {
    const auto layers = film.layers();
    mask = layer_of(layers, "depth").data;
    // The halves are of the whole irradiance; where only a part is asked for, its noise is the whole's at most.
    return {.irradiance = layer_of(layers, lights_only ? "irradiance_lights" : "irradiance"),
            .noise = noise_of_halves(layer_of(layers, "irradiance"), layer_of(layers, "irradiance_half"), mask)};
}

/// As the view's camera shows it.
Image picture_of(const Film& film, const RenderScene::View& view) {
    const Image radiance = film.layers().front().image;
    return displayable("hdr", radiance, exposure_for(view, radiance));
}

std::filesystem::path file_of(const SceneChoice& choice, uvec2 size, const char* kind, const std::filesystem::path& folder) {
    return folder / fmt::format("{}_{}x{}_{}.exr", std::filesystem::path(choice.scene).stem().string(), size.x, size.y, kind);
}

}  // namespace

ViewTruths make_truths(const SceneChoice& choice, uvec2 size, std::uint32_t spp, const std::filesystem::path& folder, const std::function<void(double)>& tell) {
    App app = open_scene(choice);
    RenderScene scene;
    extract(app.world, scene);
    if (!scene.view) fail("scene '{}' has no active camera to measure from", choice.scene);
    const auto make = [&](const char* kind, TransportSettings transport, double before) {
        transport.pixel_area = false;
        return film_of(scene, choice.scene, size, transport, spp, file_of(choice, size, kind, folder), [&](double share) { tell(before + share / 3.0); });
    };
    ViewTruths truths;
    const RenderScene whole = scene;
    truths.open = truth_of(make("open", {.bounces = 1, .occlusion = false, .reflection = Reflection::diffuse}, 0.0), true, truths.mask);
    // Without sky and glow, so that the file's noise is that of the part that is compared.
    scene.sky_radiance = vec3(0.0f);
    for (MaterialEntry& entry : scene.materials) entry.material.emission = 0.0f;
    truths.one = truth_of(make("one", {.bounces = 1, .reflection = Reflection::diffuse}, 1.0 / 3.0), true, truths.mask);
    scene = whole;
    const Film full = make("full", {}, 2.0 / 3.0);
    truths.full = truth_of(full, false, truths.mask);
    truths.picture = picture_of(full, *scene.view);
    return truths;
}

FullTruth make_full_truth(const SceneChoice& choice, uvec2 size, std::uint32_t spp, const std::filesystem::path& folder) {
    App app = open_scene(choice);
    RenderScene scene;
    extract(app.world, scene);
    if (!scene.view) fail("scene '{}' has no active camera to measure from", choice.scene);
    const Film film = film_of(scene, choice.scene, size, {.pixel_area = false}, spp, file_of(choice, size, "full", folder), [](double) {});
    FullTruth full;
    full.truth = truth_of(film, false, full.mask);
    full.picture = picture_of(film, *scene.view);
    return full;
}

Drawn draw_once(const SceneChoice& choice, Renderer& renderer, uvec2 size, const Executor::OnStep& on_step) {
    App app = open_scene(choice);
    const Capture captured = capture(app, renderer, {.width = size.x, .height = size.y, .layers = true, .on_step = on_step});
    return {.irradiance = layer_of(captured.layers, "irradiance"), .picture = captured.picture};
}

}  // namespace sl
