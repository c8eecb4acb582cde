// SPDX-License-Identifier: MIT
#include "engine/render/gl/gl.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <ranges>

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
    double speed = 10.0, seconds = 60.0, height = 30.0, from = 0.0, view_distance = TerrainView{}.distance, least_rate = TerrainView{}.least_rate;
};

using Watch = std::chrono::steady_clock;

double seconds_since(Watch::time_point start) {
    return std::chrono::duration<double>(Watch::now() - start).count();
}

void print_part(const std::string& name, std::vector<double> frames, const World& world) {
    if (frames.empty()) return;
    std::ranges::sort(frames);
    const auto at = [&](double share) { return 1e3 * frames[static_cast<std::size_t>(share * static_cast<double>(frames.size() - 1))]; };
    fmt::print("{:<14}{:>8}{:>10.1f}{:>10.1f}{:>10.1f}{:>10}{:>10.0f}{:>10.0f}\n", name, frames.size(), at(0.5), at(0.99), at(1.0), world.resource<MeshPool>().size(), allocated_megabytes(), resident_megabytes());
    std::fflush(stdout);
}

/// What one frame did, by name: its systems, its passes, and the rest of it, of which the parts of renderer and facets tell more.
std::map<std::string, double> parts_of(BenchWindow& window, double milliseconds) {
    std::map<std::string, double> parts;
    double known = 0.0;
    for (const SystemTiming& system : window.app.schedule.timings()) {
        parts[fmt::format("system {}", system.name)] += 1e3 * system.seconds;
        known += 1e3 * system.seconds;
    }
    for (const gl::SpanTime& pass : pass_times(window.renderer.executor().finished_timings())) {
        parts[pass.name] += pass.milliseconds;
        known += pass.milliseconds;
    }
    for (const WorkTimes::Part& part : window.renderer.times().parts()) parts[fmt::format("renderer {}", part.name)] = part.milliseconds;
    for (const WorkTimes::Part& part : window.renderer.facets().times().parts()) parts[fmt::format("facets {}", part.name)] = part.milliseconds;
    parts["the rest"] = milliseconds - known;
    return parts;
}

/// Where the time of all frames went, and that of the frames that a player notices.
class FrameParts {
  public:
    /// `place`: m along the way.
    void add(double place, double milliseconds, const ProcessUse& use, const std::map<std::string, double>& parts) {
        Frame& frame = frames_.emplace_back(Frame{.place = place, .milliseconds = milliseconds, .use = use});
        for (const auto& [name, part] : parts) {
            const std::size_t row = rows_.try_emplace(name, rows_.size()).first->second;
            if (frame.parts.size() <= row) frame.parts.resize(row + 1, absent);
            frame.parts[row] = static_cast<float>(part);
        }
    }
    /// Each long frame with what took longer in it than it does on average.
    void print_long() const {
        fmt::print("\nover {:.0f} ms:", noticed);
        bool any = false;
        // The first waits for all that is near.
        for (std::size_t number = 1; number < frames_.size(); ++number) {
            if (frames_[number].milliseconds <= noticed) continue;
            std::vector<std::pair<double, std::string>> more;
            for (const auto& [name, row] : rows_) more.emplace_back(frames_[number].at(row) - mean(row, frames_), name);
            std::ranges::sort(more, std::greater{});
            const Frame& frame = frames_[number];
            fmt::print("\nframe {}, at {:.0f} m: {:.0f} ms; processors {:.0f} ms, of which the system {:.0f}; {} pages, of which from disk {}; over the mean:", number + 1, frame.place, frame.milliseconds,
                       1e3 * frame.use.seconds, 1e3 * frame.use.in_system, frame.use.pages, frame.use.from_disk);
            for (const auto& [excess, name] : more | std::views::take(8)) fmt::print(" {} +{:.0f}", name, excess);
            any = true;
        }
        fmt::print("{}\n", any ? "" : " none");
    }
    void print() const {
        std::vector<Frame> slowest = frames_;
        std::ranges::sort(slowest, std::greater{}, &Frame::milliseconds);
        slowest.resize((slowest.size() + 99) / 100);
        fmt::print("\n{:<32}{:>16}{:>16}{:>24}\n", "part", "ms per frame", "% of frames", "ms in the slowest 1 %");
        for (const auto& [name, row] : rows_) {
            const auto there = static_cast<double>(std::ranges::count_if(frames_, [&](const Frame& frame) { return row < frame.parts.size() && frame.parts[row] != absent; }));
            const double usual = mean(row, frames_), slow = mean(row, slowest);
            if (std::max(usual, slow) >= 0.01) fmt::print("{:<32}{:>16.2f}{:>16.1f}{:>24.2f}\n", name, usual, 100.0 * there / static_cast<double>(frames_.size()), slow);
        }
    }

  private:
    static constexpr double noticed = 250.0;
    static constexpr float absent = -1.0f;
    struct Frame {
        double place;                ///< m along the way
        double milliseconds;
        ProcessUse use;              ///< in this frame
        std::vector<float> parts{};  ///< by their rows

        double at(std::size_t row) const { return row < parts.size() && parts[row] != absent ? static_cast<double>(parts[row]) : 0.0; }
    };
    static double mean(std::size_t row, const std::vector<Frame>& frames) {
        double sum = 0.0;
        for (const Frame& frame : frames) sum += frame.at(row);
        return sum / static_cast<double>(frames.size());
    }

    std::map<std::string, std::size_t> rows_;
    std::vector<Frame> frames_;
};

int run_flight(const GlobalFlags& global, const FlightFlags& flags) {
    Headless headless(global);
    BenchWindow window{.app = open_scene({.scene = flags.scene, .gi = flags.gi, .sets = {}}), .size = parse_size(flags.size)};
    World& world = window.app.world;
    world.resource<TerrainView>() = {.distance = flags.view_distance, .least_rate = flags.least_rate, .at_once = false};
    auto& place = world.get<Transform>(active_camera(world));
    place.translation.x += flags.from;
    place.translation.y = flags.height;
    fmt::print("{}\n{:<14}{:>8}{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}\n", headless.context->renderer(), "flown, s", "frames", "median ms", "p99 ms", "worst ms", "meshes", "in use MB", "held MB");
    std::vector<double> frames, all;
    FrameParts parts;
    constexpr double part = 10.0;
    double part_end = part;
    for (const auto start = Watch::now(); seconds_since(start) < flags.seconds;) {
        const auto frame_start = Watch::now();
        const ProcessUse before = process_use();
        window.draw(false);
        // A window waits here as well.
        glFinish();
        frames.push_back(seconds_since(frame_start));
        parts.add(world.get<Transform>(active_camera(world)).translation.x, 1e3 * frames.back(), process_use() - before, parts_of(window, 1e3 * frames.back()));
        all.push_back(frames.back());
        world.resource<FrameClock>().step = frames.back();
        world.get<Transform>(active_camera(world)).translation.x += flags.speed * frames.back();
        if (seconds_since(start) < part_end) continue;
        print_part(fmt::format("{:.0f}", part_end), std::exchange(frames, {}), world);
        part_end += part;
    }
    print_part("all", all, world);
    parts.print_long();
    parts.print();
    headless.check_errors();
    return 0;
}

}  // namespace

void add_bench_flight_command(const Flags& bench, const GlobalFlags& global) {
    auto flags = std::make_shared<FlightFlags>();
    const Flags command = bench.command("flight", "Frame times and memory while the camera flies straight ahead over endless terrain, which comes as in a window");
    command.add("--scene,PATH", flags->scene, "Scene to fly over");
    command.add("--gi", flags->gi, "GI method");
    command.add("--size", flags->size, "WIDTHxHEIGHT in pixels");
    command.add("--speed", flags->speed, "m/s; a block is half a metre").within(0.0, 1000.0);
    command.add("--seconds", flags->seconds, "How long to fly").within(1.0, 3600.0);
    command.add("--from", flags->from, "Where to begin, m along the way; every 1024 m all coordinates get another origin").within(-1e6, 1e6);
    command.add("--height", flags->height, "Of the camera, m").within(-1000.0, 1000.0);
    command.add("--least-rate", flags->least_rate, "Frames per second below which land is shown less far; 0 shows all").within(0.0, 1000.0);
    command.add("--view-distance", flags->view_distance, "How far off land is made, m").within(32.0, 512.0);
    command.runs([&global, flags] { return run_flight(global, *flags); });
}

}  // namespace sl
