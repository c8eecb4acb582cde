// SPDX-License-Identifier: MIT
#include "game/app/growth_point.h"

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/ecs/components.h"
#include "engine/ecs/set_field.h"
#include "engine/measure/metrics.h"
#include "game/app/bench_window.h"
#include "game/app/own_process.h"
#include "game/voxel/generators.h"
#include "game/voxel_content.h"

namespace sl {

namespace {

constexpr std::uint32_t warm_up_frames = 2, frames = 16;
constexpr double step = 0.03;                     // m that the camera moves per frame
constexpr float turn = 0.0043633f;                // rad, a quarter of a degree
constexpr double quick_ms = 1000.0;               // what is lit sooner is lit twice: the first time compiles shaders
constexpr double blocks_per_column = 8.5;         // of the generator "terrain"
constexpr double lamp_reach = 16.0;               // m from the camera, to each side
constexpr float lamp_height = 2.5f, lamp_range = 16.0f;

/// Points of a square that fill it evenly however many there are (Roberts' R2 sequence).
glm::dvec2 spread_point(std::uint32_t number) {
    const glm::dvec2 place = 0.5 + static_cast<double>(number) * glm::dvec2(0.7548776662466927, 0.5698402909980532);
    return place - glm::floor(place);
}

/// The world's surface under a point, or none.
std::optional<double> ground_at(World& world, dvec3 above) {
    const auto pick = pick_block(world, above, vec3(0, -1, 0), 200.0f);
    if (!pick) return std::nullopt;
    const float block = world.resource<VoxelVolumes>().at(world.get<VoxelContent>(pick->entity).volume).block_size();
    return world.get<WorldTransform>(pick->entity).origin.y + double{block} * (pick->cell.y + 1);
}

/// Hills in the sun under the scene "empty"'s camera.
App open_hills(std::uint64_t blocks) {
    App app = open_scene({.scene = "empty", .gi = "off"});
    const auto names = generator_names();
    const auto generator = static_cast<std::size_t>(std::ranges::find(names, "terrain") - names.begin());
    const auto width = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(blocks) / blocks_per_column)));
    app.world.create(Transform{}, VoxelGenerator{.generator = generator, .width = width, .depth = width});
    app.world.create(Transform{}, SunAngles{}, DirectionalLight{});
    app.world.create(SkyLight{});
    app.schedule.run(app.world);
    const double ground = ground_at(app.world, dvec3(0.1, 100.0, 0.1)).value_or(0.0);
    auto& camera = app.world.get<Transform>(active_camera(app.world));
    camera.translation = dvec3(0.1, ground + 4.0, 0.1);
    camera.rotation = glm::angleAxis(-0.3f, vec3(1, 0, 0));  // even the smallest of them fill half of the picture
    app.schedule.run(app.world);
    return app;
}

/// Whether a method takes its light from maps of the lights: then point lights give it none.
bool reflects_maps(const std::string& gi) {
    return map_size(GiSettings{make_gi_method(gi.substr(0, gi.find(':')))}) > 0;
}

/// Lamps over the ground round the camera: spots and points in turn, or only spots.
void add_lamps(World& world, std::uint32_t count, bool only_spots) {
    const dvec3 middle = world.get<WorldTransform>(active_camera(world)).origin;
    std::uint32_t number = 0, added = 0;
    while (added < count) {
        if (number > 8 * count + 64) fail("there is ground under {} of {} lamps only; choose another --scene", added, count);
        const glm::dvec2 place = (2.0 * spread_point(number++) - 1.0) * lamp_reach;
        const auto ground = ground_at(world, middle + dvec3(place.x, 40.0, place.y));
        if (!ground) continue;
        Transform stand{.translation = {middle.x + place.x, *ground + double{lamp_height}, middle.z + place.y}};
        if (only_spots || added % 2 == 0) {
            const float heading = 2.4f * static_cast<float>(added);
            stand.rotation = glm::angleAxis(heading, vec3(0, 1, 0)) * glm::angleAxis(-1.0f, vec3(1, 0, 0));
            world.create(stand, SpotLight{.intensity = 4000.0f, .range = lamp_range, .shadow_size = 128});
        } else {
            world.create(stand, PointLight{.intensity = 1000.0f, .range = lamp_range, .shadow_size = 128});
        }
        ++added;
    }
}

/// Blocks at places of the picture that no earlier frame has used.
void place_blocks(World& world, std::uint32_t frame, std::uint32_t count) {
    for (std::uint32_t i = 0; i < count; ++i) {
        const vec2 place(spread_point(frame * count + i));
        place_block(world, (place - vec2(0.5f, 0.6f)) * vec2(1.6f, 0.8f));
    }
}

/// Without the method, so that what it adds to memory can be told.
App open_without_gi(const GrowthPoint& point) {
    App app = point.blocks > 0 ? open_hills(point.blocks) : open_scene({.scene = point.choice.scene, .gi = "off"});
    if (!active_camera(app.world)) fail("scene '{}' has no active camera to measure from", point.choice.scene);
    add_lamps(app.world, point.lamps, reflects_maps(point.choice.gi));
    return app;
}

}  // namespace

GrowthCost measure_growth(const GlobalFlags& global, const GrowthPoint& point) {
    Headless headless(global);
    BenchWindow window{.app = open_without_gi(point), .size = point.size};
    window.draw(true);
    const VoxelStats stats = window.app.world.resource<VoxelStats>();
    GrowthCost cost{.renderer = headless.context->renderer(), .blocks = stats.total.blocks, .triangles = stats.total.triangles};
    const double memory = resident_megabytes();
    choose_gi(window.app, point.choice.gi);
    for (const std::string& assignment : point.choice.sets) set_field(window.app.world, window.app.registry(), assignment);
    window.draw(true);
    if (window.milliseconds < quick_ms) {
        window.renderer.forget();
        window.draw(true);
    }
    cost.anew_ms = window.milliseconds;
    std::vector<double> times;
    for (std::uint32_t frame = 0; frame < warm_up_frames + frames; ++frame) {
        move_camera(window.app.world, step, turn);
        place_blocks(window.app.world, frame, point.edits);
        window.draw(false);
        if (frame >= warm_up_frames) times.push_back(window.milliseconds);
    }
    cost.gi_ms = spread_of(times);
    cost.memory_mb = resident_megabytes() - memory;
    const Image last = window.irradiance();
    window.draw(true);
    cost.catch_up_ms = window.milliseconds;
    // Without indirect light there is one pixel, and nothing to wait for.
    if (last.width == point.size.x) cost.behind = image_errors(last, window.irradiance(), window.depth().data).nrmse;
    headless.check_errors();
    return cost;
}

}  // namespace sl
