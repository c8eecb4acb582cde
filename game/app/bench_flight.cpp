// SPDX-License-Identifier: MIT
#include "engine/render/gl/gl.h"

#include <algorithm>
#include <chrono>
#include <map>

#include "engine/core/clock.h"
#include "engine/ecs/components.h"
#include "engine/render/pass_times.h"
#include "game/app/bench_window.h"
#include "game/app/own_process.h"
#include "game/streaming/terrain_stream.h"

namespace sl {

namespace {

struct FlightFlags {
    std::string scene = "endless", size = "640x360", gi = "facets";
    double speed = 10.0, seconds = 60.0, height = 30.0, from = 0.0, view_distance = TerrainView{}.distance;
};

using Watch = std::chrono::steady_clock;

double seconds_since(Watch::time_point start) {
    return std::chrono::duration<double>(Watch::now() - start).count();
}

void print_part(const std::string& name, std::vector<double> frames, const World& world) {
    if (frames.empty()) return;
    std::ranges::sort(frames);
    const auto at = [&](double share) { return 1e3 * frames[static_cast<std::size_t>(share * static_cast<double>(frames.size() - 1))]; };
    fmt::print("{:<14}{:>8}{:>10.1f}{:>10.1f}{:>10.1f}{:>10}{:>10.0f}\n", name, frames.size(), at(0.5), at(0.99), at(1.0), world.resource<MeshPool>().size(), resident_megabytes());
    std::fflush(stdout);
}

/// Frames that a player notices, but for the first, which waits for all that is near.
void print_long_frames(std::span<const double> frames) {
    constexpr double noticed = 0.25;
    std::string list;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        if (frames[i] > noticed) list += fmt::format("{}{:.0f} ms (frame {})", list.empty() ? "" : ", ", 1e3 * frames[i], i + 1);
    }
    fmt::print("\nover {:.0f} ms: {}\n", 1e3 * noticed, list.empty() ? "none" : list);
}

/// How much of all frames each kind of pass took, and how often it ran.
class PassTotals {
  public:
    void add(std::span<const gl::SpanTime> spans) {
        for (const gl::SpanTime& span : pass_times(spans)) {
            Total& total = totals_[span.name];
            total.milliseconds += span.milliseconds;
            ++total.frames;
        }
    }
    void print(std::size_t frames) const {
        fmt::print("\n{:<24}{:>16}{:>16}\n", "pass", "ms per frame", "% of frames");
        for (const auto& [name, total] : totals_) {
            const auto count = static_cast<double>(frames);
            fmt::print("{:<24}{:>16.2f}{:>16.1f}\n", name, total.milliseconds / count, 100.0 * total.frames / count);
        }
    }

  private:
    struct Total {
        double milliseconds = 0.0, frames = 0.0;
    };
    std::map<std::string, Total> totals_;
};

int run_flight(const GlobalFlags& global, const FlightFlags& flags) {
    Headless headless(global);
    BenchWindow window{.app = open_scene({.scene = flags.scene, .gi = flags.gi, .sets = {}}), .size = parse_size(flags.size)};
    World& world = window.app.world;
    world.resource<TerrainView>() = {.distance = flags.view_distance, .at_once = false};
    auto& place = world.get<Transform>(active_camera(world));
    place.translation.x += flags.from;
    place.translation.y = flags.height;
    fmt::print("{}\n{:<14}{:>8}{:>10}{:>10}{:>10}{:>10}{:>10}\n", headless.context->renderer(), "flown, s", "frames", "median ms", "p99 ms", "worst ms", "meshes", "MB");
    std::vector<double> frames, all;
    PassTotals passes;
    constexpr double part = 10.0;
    double part_end = part;
    for (const auto start = Watch::now(); seconds_since(start) < flags.seconds;) {
        const auto frame_start = Watch::now();
        window.draw(false);
        // A window waits here as well.
        glFinish();
        frames.push_back(seconds_since(frame_start));
        passes.add(window.renderer.executor().finished_timings());
        all.push_back(frames.back());
        world.resource<FrameClock>().step = frames.back();
        world.get<Transform>(active_camera(world)).translation.x += flags.speed * frames.back();
        if (seconds_since(start) < part_end) continue;
        print_part(fmt::format("{:.0f}", part_end), std::exchange(frames, {}), world);
        part_end += part;
    }
    print_part("all", all, world);
    print_long_frames(all);
    passes.print(all.size());
    headless.check_errors();
    return 0;
}

}  // namespace

void add_bench_flight_command(const Flags& bench, const GlobalFlags& global) {
    auto flags = std::make_shared<FlightFlags>();
    const Flags command = bench.command("flight", "Frame times and memory while the camera flies straight ahead over endless terrain, which comes as in a window");
    command.add("--scene", flags->scene, "Scene to fly over");
    command.add("--gi", flags->gi, "GI method");
    command.add("--size", flags->size, "WIDTHxHEIGHT in pixels");
    command.add("--speed", flags->speed, "m/s; a block is half a metre").within(0.0, 1000.0);
    command.add("--seconds", flags->seconds, "How long to fly").within(1.0, 3600.0);
    command.add("--from", flags->from, "Where to begin, m along the way; every 1024 m all coordinates get another origin").within(-1e6, 1e6);
    command.add("--height", flags->height, "Of the camera, m").within(-1000.0, 1000.0);
    command.add("--view-distance", flags->view_distance, "How far off land is made, m").within(32.0, 512.0);
    command.runs([&global, flags] { return run_flight(global, *flags); });
}

}  // namespace sl
