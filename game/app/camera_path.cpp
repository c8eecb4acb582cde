// SPDX-License-Identifier: MIT
#include "game/app/camera_path.h"

#include <algorithm>

#include "engine/core/error.h"
#include "engine/render/image_layers.h"
#include "engine/render/reference/reference.h"
#include "engine/render/scene/extract.h"
#include "game/app/bench_window.h"

namespace sl {

namespace {

constexpr double step = 0.03;       // m to the right per frame
constexpr float turn = 0.0043633f;  // rad to the left per frame, a quarter of a degree

Image layer_of(const std::vector<ImageLayer>& layers, std::string_view name) { return std::ranges::find(layers, name, &ImageLayer::name)->image; }

/// The mean of all samples is wrong by as much as half of them differ from it, on average: an error of the same size.
Image error_of(const std::vector<ImageLayer>& layers) {
    const Image whole = layer_of(layers, "irradiance");
    Image error = layer_of(layers, "irradiance_half");
    std::ranges::transform(error.data, whole.data, error.data.begin(), std::minus{});
    return error;
}

}  // namespace

std::vector<PathFrame> drawn_along(const CameraPath& path, const std::string& gi, const std::vector<std::string>& sets, const TellFrames& tell) {
    BenchWindow window{.app = open_scene({.scene = path.scene, .gi = gi, .sets = sets}), .size = path.size};
    std::vector<PathFrame> frames;
    for (std::uint32_t i = 0; i < path.frames; ++i) {
        if (i > 0) move_camera(window.app.world, step, turn);
        window.draw(i == 0);
        frames.push_back({.view = frame_params(window.scene, path.size.x, path.size.y, i), .depth = window.depth(), .normal = decoded_normals(window.normal()), .value = window.irradiance()});
        if (frames.back().value.width != path.size.x) fail("{} makes no indirect light that could flicker", gi);
        tell(i + 1);
    }
    return frames;
}

std::vector<PathFrame> traced_along(const CameraPath& path, std::uint32_t samples, const TellFrames& tell) {
    App app = open_scene({.scene = path.scene, .gi = "off"});
    RenderScene scene;
    std::vector<PathFrame> frames;
    const std::uint32_t pairs = (samples + 1) / 2;  // both halves get as many
    for (std::uint32_t i = 0; i < path.frames; ++i) {
        if (i > 0) move_camera(app.world, step, turn);
        app.schedule.run(app.world);
        extract(app.world, scene);
        if (!scene.view) fail("scene '{}' has no active camera to measure from", path.scene);
        Film film(path.size);
        trace_reference(PathTracer(scene, path.size, {.pixel_area = false}), film, {.block = {.high = path.size, .first = 2 * pairs * i, .last = 2 * pairs * (i + 1)}}, {});
        const auto layers = film.layers();
        frames.push_back({.view = frame_params(scene, path.size.x, path.size.y, i), .depth = layer_of(layers, "depth"), .normal = layer_of(layers, "normal"),
                          .value = layer_of(layers, "irradiance"), .error = error_of(layers)});
        tell(i + 1);
    }
    return frames;
}

}  // namespace sl
