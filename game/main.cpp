// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <cstdio>

#include "engine/core/error.h"
#include "engine/core/log.h"
#include "game/app/commands.h"

namespace {

int run(int argc, char** argv) {
    CLI::App cli("Secondlight: a game engine whose global illumination comes with its error measured.\n"
                 "Without a command it opens the game in a window, or, where there is no display, renders a tour into out/.");
    cli.name("secondlight");
    cli.set_version_flag("--version", "secondlight 0.1.0");
    sl::GlobalFlags flags;
    cli.add_option("--context", flags.context, "Where OpenGL comes from: auto, window, egl (no display), osmesa (no GPU stack)")
        ->capture_default_str();
    cli.add_option("--log", flags.log_level, "Least level of messages: trace, debug, info, warn, error")->capture_default_str();
    cli.require_subcommand(0, 1);
    cli.fallthrough();

    sl::Command chosen;
    const sl::Flags program(cli, chosen);
    sl::add_play_command(program, flags);
    sl::add_capture_command(program, flags);
    sl::add_tour_command(program, flags);
    sl::add_list_command(program, flags);
    sl::add_bench_command(program, flags);
    sl::add_reference_command(program);
    sl::add_merge_command(program);
    sl::add_compare_command(program);
    if (argc == 1) {
        // Bare, the program does its main job.
        const char* arguments[] = {argv[0], sl::has_display() ? "play" : "tour"};
        cli.parse(2, arguments);
    } else {
        try {
            cli.parse(argc, argv);
        } catch (const CLI::ParseError& error) {
            const int code = cli.exit(error);
            return code == 0 ? 0 : 2;
        }
    }
    sl::init_log(flags.log_level.c_str());
    if (!chosen) {
        fmt::print(stderr, "{}", cli.help());
        return 2;
    }
    return chosen();
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
