// SPDX-License-Identifier: MIT
#include <cstdio>

#include "engine/core/error.h"
#include "engine/core/log.h"
#include "game/app/commands.h"
#include "game/app/own_process.h"

namespace {

int run(int argc, char** argv) {
    sl::GlobalFlags flags;
    const sl::Program program{
        .name = "secondlight",
        .about = "Secondlight: a game engine whose global illumination comes with its error measured.\n"
                 "Without a command it opens the game in a window, or, where there is no display, renders a tour into out/.",
        .version = SL_VERSION,
        .declare =
            [&](const sl::Flags& line) {
                line.add("--context", flags.context, "Where OpenGL comes from: auto, window, egl (no display), osmesa (no GPU stack)");
                line.add("--log", flags.log_level, "Least level of messages").one_of({"trace", "debug", "info", "warn", "error"});
                line.toggle("--allow-outside", flags.outside_files, "Let models read buffers and pictures outside their own folder");
                sl::add_play_command(line, flags);
                sl::add_capture_command(line, flags);
                sl::add_tour_command(line, flags);
                sl::add_list_command(line, flags);
                sl::add_export_command(line);
                sl::add_inspect_command(line);
                sl::add_schema_command(line);
                sl::add_reference_command(line);
                sl::add_merge_command(line);
                sl::add_compare_command(line);
                const sl::Flags bench = line.command("bench", "Measure speed, and speed against error");
                bench.needs_command();
                sl::add_bench_onoff_command(bench, flags);
                sl::add_bench_changes_command(bench, flags);
                sl::add_bench_day_command(bench, flags);
                sl::add_bench_growth_command(bench, flags);
                sl::add_bench_motion_command(bench, flags);
                sl::add_bench_flight_command(bench, flags);
                sl::add_bench_gi_command(bench, flags);
                sl::add_bench_rays_command(bench);
            },
        .unnamed = [] { return sl::has_display() ? "play" : "tour"; },
        .prepare =
            [&] {
                sl::keep_little_memory();
                sl::init_log(flags.log_level.c_str());
                sl::allow_outside_files(flags.outside_files);
            },
    };
    return program.run(argc, argv);
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        fmt::print(stderr, "secondlight: error: {}\n", error.what());
        return 1;
    }
}
