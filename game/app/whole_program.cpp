// SPDX-License-Identifier: MIT
#include "engine/core/log.h"
#include "game/app/commands.h"
#include "game/app/own_process.h"

namespace sl {

Program whole_program(GlobalFlags& flags) {
    return {
        .name = "secondlight",
        .about = "Secondlight: a game engine whose global illumination comes with its error measured.\n"
                 "Without a command it opens the game in a window, or, where there is no display, renders a tour into out/.",
        .version = SL_VERSION,
        .declare =
            [&flags](const Flags& line) {
                line.add("--context", flags.context, "Where OpenGL comes from: auto, window, egl (no display), osmesa (no GPU stack)");
                line.add("--log", flags.log_level, "Least level of messages").one_of({"trace", "debug", "info", "warn", "error"});
                line.toggle("--allow-outside", flags.outside_files, "Let models read buffers and pictures outside their own folder");
                add_play_command(line, flags);
                add_capture_command(line, flags);
                add_tour_command(line, flags);
                add_list_command(line, flags);
                add_export_command(line);
                add_generate_command(line);
                add_inspect_command(line);
                add_schema_command(line);
                add_reference_command(line);
                add_merge_command(line);
                add_compare_command(line);
                const Flags bench = line.command("bench", "Measure speed, and speed against error");
                bench.needs_command();
                add_bench_onoff_command(bench, flags);
                add_bench_changes_command(bench, flags);
                add_bench_day_command(bench, flags);
                add_bench_growth_command(bench, flags);
                add_bench_motion_command(bench, flags);
                add_bench_flight_command(bench, flags);
                add_bench_gi_command(bench, flags);
                add_bench_models_command(bench, flags);
                add_bench_rays_command(bench);
            },
        .unnamed = [] { return has_display() ? "play" : "tour"; },
        .prepare =
            [&flags] {
                keep_little_memory();
                init_log(flags.log_level.c_str());
                allow_outside_files(flags.outside_files);
            },
    };
}

}  // namespace sl
