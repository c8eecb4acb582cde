// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/text_file.h"
#include "engine/ecs/components.h"
#include "engine/ecs/query.h"
#include "engine/measure/metrics.h"
#include "game/app/bench_window.h"
#include "game/app/progress.h"

namespace sl {

namespace {

/// Tells the torch from other lights, m.
constexpr float torch_range = 15.5f;

struct ChangesFlags {
    std::string size = "640x360";
    std::vector<std::string> scenes{"outdoor", "indoor"};
    std::string gi = "facets";
    std::vector<std::string> sets;
    std::uint32_t frames = 64;
    std::string json, only;
};

/// Something that happens in a game, and what has to be there first.
struct Change {
    std::string name;
    std::function<void(World&)> prepare, make;
    bool from_nothing = false;  ///< no light is known before
};

dvec3 before_camera(World& world, double distance) {
    const auto& camera = world.get<WorldTransform>(active_camera(world));
    return camera.origin - distance * dvec3(glm::normalize(camera.linear[2]));
}

Entity torch(World& world) {
    for (auto [entity, light, transform] : Query<const PointLight, Transform>(world)) {
        if (light.range == torch_range) return entity;
    }
    return {};
}

std::vector<Change> changes() {
    return {{"a game begins", [](World&) {}, [](World&) {}, true},
            {"the camera turns round", [](World&) {}, [](World& world) { move_camera(world, 0.0, pi); }},
            {"a block is placed", [](World&) {}, [](World& world) { place_block(world); }},
            {"a torch moves by 1 m",
             [](World& world) {
                 world.create(Transform{.translation = before_camera(world, 3.0)}, PointLight{.intensity = 20000.0f, .range = torch_range});
             },
             [](World& world) { world.get<Transform>(torch(world)).translation.x += 1.0; }},
            {"the sun turns by 10 deg", [](World&) {},
             [](World& world) {
                 for (auto [entity, sun] : Query<SunAngles>(world)) sun.azimuth += glm::radians(10.0f);
             }},
            {"the sun moves by a step of the day", [](World&) {},
             [](World& world) {
                 for (auto [entity, sun] : Query<SunAngles>(world)) sun.azimuth += DayCycle{}.step;
                 // Where there is a day, strength and colour of sun and sky change as well.
                 for (auto [entity, day] : Query<DayCycle>(world)) day.hour += glm::degrees(double{day.step}) / 15.0;
             }}};
}

struct Shot {
    Image irradiance;
    double milliseconds;
};

/// Share of surface pixels that are within a tenth of what they come to.
double settled_share(const Image& now, const Image& end, const std::vector<float>& surface) {
    double good = 0.0, all = 0.0;
    for (std::size_t i = 0; i < surface.size(); ++i) {
        if (surface[i] <= 0.0f) continue;
        const auto brightness = [&](const Image& image) { return image.data[i * image.channels] + image.data[i * image.channels + 1] + image.data[i * image.channels + 2]; };
        good += std::abs(brightness(now) - brightness(end)) <= 0.1f * brightness(end) ? 1.0 : 0.0;
        all += 1.0;
    }
    return all > 0.0 ? good / all : 1.0;
}

bool shown(std::size_t frame, std::size_t frames) { return frame <= 4 || std::has_single_bit(frame) || frame == frames; }

nlohmann::json measure(const std::string& scene, const Change& change, const ChangesFlags& flags) {
    BenchWindow window{.app = open_scene({.scene = scene, .gi = flags.gi, .sets = flags.sets}), .size = parse_size(flags.size)};
    change.prepare(window.app.world);
    Progress progress(fmt::format("{}, {}", scene, change.name));
    const Image black(window.size.x, window.size.y, 4);
    if (!change.from_nothing) window.draw(true);
    const Image before = change.from_nothing ? black : window.irradiance();
    change.make(window.app.world);
    std::vector<Shot> shots;
    for (std::uint32_t frame = 0; frame < flags.frames; ++frame) {
        window.draw(false);
        // Before there is any light it is one black pixel.
        Image irradiance = window.irradiance();
        if (irradiance.width != window.size.x) irradiance = black;
        shots.push_back({std::move(irradiance), window.milliseconds});
        progress.update(frame + 1, flags.frames);
    }
    window.draw(true);
    const Image end = window.irradiance(), depth = window.depth();
    fmt::print("\n{} · {} · {}\n  changes the light by {:.1f} % (NRMSE)\n  {:>6}{:>12}{:>14}{:>24}\n", scene, flags.gi, change.name,
               100.0 * image_errors(before, end, depth.data).nrmse, "frame", "GI ms", "NRMSE", "pixels within 10 %");
    nlohmann::json json{{"scene", scene}, {"change", change.name}, {"size", image_errors(before, end, depth.data).nrmse}};
    for (std::size_t i = 0; i < shots.size(); ++i) {
        const double nrmse = image_errors(shots[i].irradiance, end, depth.data).nrmse, share = settled_share(shots[i].irradiance, end, depth.data);
        if (shown(i + 1, shots.size())) fmt::print("  {:>6}{:>12.1f}{:>12.1f} %{:>22.1f} %\n", i + 1, shots[i].milliseconds, 100.0 * nrmse, 100.0 * share);
        json["frames"].push_back({{"gi_ms", shots[i].milliseconds}, {"nrmse", nrmse}, {"within_tenth", share}});
    }
    return json;
}

int run_changes(const GlobalFlags& global, const ChangesFlags& flags) {
    const uvec2 size = parse_size(flags.size);
    Headless headless(global);
    fmt::print("{} · {} · {}x{}\n", headless.context->renderer(), headless.context->version(), size.x, size.y);
    nlohmann::json results = nlohmann::json::array();
    for (const std::string& scene : flags.scenes) {
        for (const Change& change : changes()) {
            if (flags.only.empty() || change.name == flags.only) results.push_back(measure(scene, change, flags));
        }
    }
    headless.check_errors();
    if (!flags.json.empty()) {
        const nlohmann::json all{{"renderer", headless.context->renderer()}, {"width", size.x}, {"height", size.y}, {"gi", flags.gi}, {"results", results}};
        write_text_file(flags.json, all.dump(2) + "\n");
    }
    return 0;
}

}  // namespace

void add_bench_changes_command(const Flags& bench, const GlobalFlags& global) {
    auto flags = std::make_shared<ChangesFlags>();
    const Flags command = bench.command("changes", "How soon indirect light follows when a block is placed, a torch or the sun moves, frame by frame as in a window");
    command.add("--scene,PATH", flags->scenes, "Scenes to measure");
    command.add("--gi", flags->gi, "GI method");
    command.add("--set", flags->sets, "component.field=value; repeatable");
    command.add("--size", flags->size, "WIDTHxHEIGHT in pixels");
    std::vector<std::string> names;
    for (const Change& change : changes()) names.push_back(change.name);
    command.add("--only", flags->only, "One of them alone").one_of(names);
    command.add("--frames", flags->frames, "Frames after each change").within(1, 10000);
    command.add("--json", flags->json, "Also write the figures into this file");
    command.runs([&global, flags] { return run_changes(global, *flags); });
}

}  // namespace sl
