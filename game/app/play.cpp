// SPDX-License-Identifier: MIT
#include "game/app/play.h"

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

void add_play_command(const Flags& program, const GlobalFlags& global) {
    auto flags = std::make_shared<PlayFlags>();
    const Flags command = program.command("play", "Open the game in a window (H lists the keys)");
    add_scene_flags(command, flags->settings.scene);
    command.add("--size", flags->size, "Size of the window");
    command.toggle("--fullscreen", flags->settings.window.fullscreen,
                      "Fill the screen (F11 while playing)");
    command.toggle("--no-vsync", flags->no_vsync, "Draw as fast as possible, not in step with the screen");
    command.add("--render-scale", flags->settings.render_scale,
                     "Pixels drawn per pixel shown, along each axis").within(0.05, 4.0)
        ;
    command.add("--frames", flags->settings.max_frames, "Quit after so many frames; 0 plays on")
        ;
    command.runs([flags, &global] { return run_play(global, *flags); });
}

}  // namespace sl
