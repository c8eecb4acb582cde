// SPDX-License-Identifier: MIT
#include "game/app/bench_window.h"

#include "engine/core/error.h"
#include "engine/ecs/components.h"
#include "engine/render/pass_times.h"
#include "engine/render/scene/extract.h"
#include "game/voxel_content.h"

namespace sl {

void BenchWindow::draw(bool all) {
    app.schedule.run(app.world);
    extract(app.world, scene);
    if (!scene.view) fail("this scene has no active camera to measure from");
    renderer.executor().set_timing(true);
    const auto result = renderer.render(scene, {.width = size.x, .height = size.y, .frame_index = frame++, .slice_budget = all ? ~0u : 1u, .wanted = {"depth", "normal"}, .want_irradiance = true});
    milliseconds = gi_milliseconds(renderer.executor().finished_timings()) + 1e3 * result.images.gi_traced_seconds;
}

void move_camera(World& world, double right, float angle) {
    const Entity camera = active_camera(world);
    if (!camera) fail("this scene has no active camera to measure from");
    auto& place = world.get<Transform>(camera);
    place.translation += right * dvec3(place.rotation * vec3(1, 0, 0));
    place.rotation = glm::normalize(glm::angleAxis(angle, vec3(0, 1, 0)) * place.rotation);
}

void place_block(World& world, vec2 slope) {
    const auto& camera = world.get<WorldTransform>(active_camera(world));
    const vec3 direction = camera.linear * vec3(slope, -1.0f);
    if (const auto pick = pick_block(world, camera.origin, direction, 100.0f)) set_block(world, pick->entity, pick->cell + pick->normal, Block::stone);
}

}  // namespace sl
