// SPDX-License-Identifier: MIT
#include "engine/core/clock.h"
#include "engine/core/error.h"
#include "engine/ecs/components.h"
#include "engine/ecs/query.h"
#include "engine/measure/metrics.h"
#include "game/app/bench_window.h"
#include "game/app/progress.h"

namespace sl {

namespace {

struct DayFlags {
    std::string size = "320x180";
    std::string scene = "crystals", gi = "facets";
    std::vector<std::string> sets{"day_cycle.hour=16.5"};
    double step = 1.0, minutes = 24.0, fps = 15.0;
    std::uint32_t frames = 600;
};

DayCycle& day_of(World& world) {
    for (auto [entity, day] : Query<DayCycle>(world)) return day;
    fail("this scene has no day: give its sun a day_cycle");
}

/// How far the light is from what it should be, each time by rendering it anew until all is known.
double lag(BenchWindow& window) {
    const Image shown = window.irradiance(), depth = window.depth();
    // Time stands still meanwhile.
    const double kept = std::exchange(window.app.world.resource<FrameClock>().step, 0.0);
    BenchWindow truth{.app = std::move(window.app), .size = window.size};
    truth.draw(true);
    window.app = std::move(truth.app);
    window.app.world.resource<FrameClock>().step = kept;
    return image_errors(shown, truth.irradiance(), depth.data).nrmse;
}

void measure(const DayFlags& flags) {
    BenchWindow window{.app = open_scene({.scene = flags.scene, .gi = flags.gi, .sets = flags.sets}), .size = parse_size(flags.size)};
    World& world = window.app.world;
    day_of(world).runs = false;
    window.draw(true);
    const Image before = window.irradiance();
    const double settled = lag(window);
    DayCycle& day = day_of(world);
    day.runs = true;
    day.minutes = static_cast<float>(flags.minutes);
    day.step = static_cast<float>(glm::radians(flags.step));
    world.resource<FrameClock>().step = 1.0 / flags.fps;
    Progress progress(fmt::format("steps of {} deg", flags.step));
    std::vector<double> lags;
    double milliseconds = 0.0;
    for (std::uint32_t frame = 1; frame <= flags.frames; ++frame) {
        window.draw(false);
        milliseconds += window.milliseconds;
        // In the middle, and at the end.
        if (4 * frame % flags.frames == 0 && 2 * frame >= flags.frames) lags.push_back(lag(window));
        progress.update(frame, flags.frames);
    }
    day_of(world).runs = false;
    window.draw(true);
    const double change = image_errors(before, window.irradiance(), window.depth().data).nrmse;
    fmt::print("{:>8.2f} {:>10.1f} {:>12.1f} % {:>9.1f} %", flags.step, milliseconds / flags.frames, 100.0 * change, 100.0 * settled);
    for (const double one : lags) fmt::print(" {:>8.1f} %", 100.0 * one);
    fmt::print("\n");
}

int run_day(const GlobalFlags& global, const DayFlags& flags) {
    Headless headless(global);
    fmt::print("{} · {} · {}\n{} · {} · a day of {} minutes at {} frames per second, {} frames\n\n", headless.context->renderer(), headless.context->version(), flags.size, flags.scene, flags.gi,
               flags.minutes, flags.fps, flags.frames);
    fmt::print("{:>8} {:>10} {:>14} {:>11}   while it runs, after a half, three quarters, all\n", "step deg", "GI ms", "light changes", "settled");
    measure(flags);
    headless.check_errors();
    return 0;
}

}  // namespace

void add_bench_day_command(const Flags& bench, const GlobalFlags& global) {
    auto flags = std::make_shared<DayFlags>();
    const Flags command = bench.command("day", "How far indirect light stays behind a sun that moves, by the steps that it takes (NRMSE)");
    command.add("--scene,PATH", flags->scene, "Scene with a day");
    command.add("--gi", flags->gi, "GI method");
    command.add("--set", flags->sets, "component.field=value; repeatable");
    command.add("--size", flags->size, "WIDTHxHEIGHT in pixels");
    command.add("--step", flags->step, "Of the sun, deg").within(0.0, 10.0);
    command.add("--minutes", flags->minutes, "How long a day takes").within(0.01, 1e5);
    command.add("--fps", flags->fps, "Frames per second, as the day counts them").within(1.0, 1000.0);
    command.add("--frames", flags->frames, "Frames for each").within(4, 100000);
    command.runs([&global, flags] { return run_day(global, *flags); });
}

}  // namespace sl
