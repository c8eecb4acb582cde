// SPDX-License-Identifier: MIT
#include "game/app/bench_side.h"

#include <chrono>

#include "engine/core/error.h"
#include "engine/render/gl/gl.h"
#include "engine/render/pass_times.h"
#include "engine/render/scene/extract.h"

namespace sl {

namespace {

void turn_camera(App& app, std::uint32_t frame) {
    const Entity camera = active_camera(app.world);
    if (!camera) fail("this scene has no active camera to measure from");
    auto& rotation = app.world.get<Transform>(camera).rotation;
    const float angle = (frame % 2 == 0 ? 1.0f : -1.0f) * 1e-3f;
    rotation = glm::normalize(glm::angleAxis(angle, vec3(0, 1, 0)) * rotation);
}

}  // namespace

double BenchSide::draw(uvec2 size, std::uint32_t frame, bool per_pass) {
    turn_camera(app, frame);
    app.schedule.run(app.world);
    renderer.executor().set_timing(per_pass);
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    extract(app.world, scene);
    result_ = renderer.render(scene, {.width = size.x, .height = size.y, .frame_index = frame});
    glFinish();
    const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - start;
    return passed.count();
}

void BenchSide::measure(uvec2 size, std::uint32_t frame) {
    frames.push_back(draw(size, 2 * frame, false));
    draw(size, 2 * frame + 1, true);
    const auto& spans = renderer.executor().finished_timings();
    for (const gl::SpanTime& pass : pass_times(spans)) {
        if (!passes.contains(pass.name)) order.push_back(pass.name);
        passes[pass.name].push_back(pass.milliseconds);
    }
    gi.push_back(gi_time());
}

void BenchSide::measure_anew(uvec2 size, std::uint32_t frame) {
    renderer.forget();
    draw(size, frame, true);
    gi_anew.push_back(gi_time());
}

double BenchSide::gi_time() { return gi_milliseconds(renderer.executor().finished_timings()) + 1e3 * result_.images.gi_traced_seconds; }

}  // namespace sl
