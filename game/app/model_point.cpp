// SPDX-License-Identifier: MIT
#include "game/app/model_point.h"

#include <chrono>

#include "engine/core/error.h"
#include "engine/measure/flip.h"
#include "engine/measure/metrics.h"
#include "game/app/bench_truth.h"
#include "game/app/headless.h"
#include "game/app/own_process.h"
#include "game/model_scene.h"

namespace sl {

namespace {

using Watch = std::chrono::steady_clock;

double seconds_since(Watch::time_point start) { return std::chrono::duration<double>(Watch::now() - start).count(); }

}  // namespace

ModelLoad measure_model_load(const ModelPoint& point) {
    const auto start = Watch::now();
    App app = open_scene(point.choice);
    const ModelLoad load{.load_s = seconds_since(start), .triangles = triangles_of_meshes(app.world)};
    if (load.triangles == 0) fail("it has no triangles to show");
    return load;
}

CaptureCost measure_model_capture(const GlobalFlags& global, const ModelPoint& point) {
    const auto start = Watch::now();
    App app = open_scene(point.choice);
    Headless headless(global);
    const Capture captured = capture(app, headless.renderer, {.width = point.size.x, .height = point.size.y});
    write_png(point.folder / "capture.png", captured.picture);
    headless.check_errors();
    return {.capture_s = seconds_since(start), .peak_mb = peak_megabytes()};
}

ModelErrors measure_model_errors(const GlobalFlags& global, const ModelPoint& point) {
    SceneChoice choice = point.choice;
    choice.sets.emplace_back(no_antialiasing);
    Headless headless(global);
    const Drawn drawn = draw_once(choice, headless.renderer, point.reference_size);
    headless.check_errors();
    const FullTruth full = make_full_truth(choice, point.reference_size, point.spp, point.folder);
    write_png(point.folder / "beside_reference.png", side_by_side({drawn.picture, full.picture}, 4));
    const ErrorMetrics errors = image_errors(drawn.irradiance, full.truth.irradiance, full.mask);
    return {.nrmse = errors.nrmse, .bias = errors.bias, .reference_noise = full.truth.noise, .flip = flip(drawn.picture, full.picture, full.mask).mean};
}

}  // namespace sl
