// SPDX-License-Identifier: MIT
#include "game/app/play.h"

#include <CLI/CLI.hpp>

#include "engine/core/error.h"

namespace sl {

namespace {

struct PlayFlags {
    PlaySettings settings;
    std::string size = "1280x720";
    bool no_vsync = false;
};

int run_play(const GlobalFlags& global, PlayFlags flags) {
    const gl::ContextKind kind = gl::parse_context_kind(global.context);
    if (kind == gl::ContextKind::egl || kind == gl::ContextKind::osmesa) {
        fail(
            "play needs a window, which --context {0} has not: leave it out, or render with `./play tour "
            "--context {0}`",
            global.context);
    }
    flags.settings.window.size = parse_size(flags.size);
    flags.settings.window.vsync = !flags.no_vsync;
    Play(flags.settings).run();
    return 0;
}

}  // namespace

void add_play_command(CLI::App& cli, const GlobalFlags& global, Command& chosen) {
    auto flags = std::make_shared<PlayFlags>();
    CLI::App* command = cli.add_subcommand("play", "Open the game in a window (H lists the keys)");
    add_scene_flags(*command, flags->settings.scene);
    command->add_option("--size", flags->size, "Size of the window")->capture_default_str();
    command->add_flag("--fullscreen", flags->settings.window.fullscreen,
                      "Fill the screen (F11 while playing)");
    command->add_flag("--no-vsync", flags->no_vsync, "Draw as fast as possible, not in step with the screen");
    command
        ->add_option("--render-scale", flags->settings.render_scale,
                     "Pixels drawn per pixel shown, along each axis")
        ->check(CLI::Range(0.05, 4.0))
        ->capture_default_str();
    command->add_option("--frames", flags->settings.max_frames, "Quit after so many frames; 0 plays on")
        ->capture_default_str();
    command->callback(
        [flags, &global, &chosen] { chosen = [flags, &global] { return run_play(global, *flags); }; });
}

}  // namespace sl
