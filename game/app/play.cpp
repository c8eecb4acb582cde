// SPDX-License-Identifier: MIT
#include "game/app/play.h"

#include "engine/core/error.h"
#include "game/saved_world.h"

namespace sl {

namespace {

struct PlayFlags {
    PlaySettings settings;
    std::optional<std::string> scene, world;
    std::string size = "1280x720";
    bool new_world = false;
    bool no_vsync = false;
};

/// The world of those who choose neither world nor scene.
constexpr const char* first_world = "valley.world";
constexpr const char* first_scene = "endless";

/// What a game is played in: a world that keeps changes, or a scene that does not.
void choose_world(PlayFlags& flags) {
    PlaySettings& settings = flags.settings;
    if (flags.new_world && !flags.world) fail("--new needs to know where the world is to be: add --world PATH");
    if (flags.world && flags.scene && !flags.new_world) fail("--world {} names its scene itself: leave --scene out, or make another world with --new", *flags.world);
    settings.scene.scene = flags.scene.value_or(first_scene);
    settings.new_world = flags.new_world;
    if (flags.world) {
        settings.world = *flags.world;
    } else if (!flags.scene) {
        std::error_code ignored;
        settings.world = worlds_folder() / first_world;
        settings.new_world = settings.unsaved_if_need_be = !std::filesystem::exists(settings.world, ignored);
    }
}

int run_play(const GlobalFlags& global, PlayFlags flags) {
    const gl::ContextKind kind = gl::parse_context_kind(global.context);
    if (kind == gl::ContextKind::egl || kind == gl::ContextKind::osmesa) {
        fail(
            "play needs a window, which --context {0} has not: leave it out, or render with `./play tour "
            "--context {0}`",
            global.context);
    }
    choose_world(flags);
    flags.settings.window.size = parse_size(flags.size);
    flags.settings.window.vsync = !flags.no_vsync;
    Play(flags.settings).run();
    return 0;
}

}  // namespace

void add_play_command(const Flags& program, const GlobalFlags& global) {
    auto flags = std::make_shared<PlayFlags>();
    const Flags command = program.command("play", "Open the game in a window (H lists the keys)");
    command.add("--scene,PATH", flags->scene, scene_flag_help);
    add_setting_flags(command, flags->settings.scene);
    command.add("--world", flags->world, "World file that keeps all changes; without it and --scene, valley.world in ~/.local/share/secondlight/worlds");
    command.toggle("--new", flags->new_world, "Make that world, from --scene or the valley of the crystals in endless land");
    command.add("--size", flags->size, "Size of the window");
    command.toggle("--fullscreen", flags->settings.window.fullscreen,
                      "Fill the screen (F11 while playing)");
    command.toggle("--no-vsync", flags->no_vsync, "Draw as fast as possible, not in step with the screen");
    command.add("--render-scale", flags->settings.render_scale,
                     "Pixels drawn per pixel shown, along each axis; else as the settings have it").within(0.05, 4.0)
        ;
    command.add("--frames", flags->settings.max_frames, "Quit after so many frames; 0 plays on")
        ;
    command.runs([flags, &global] { return run_play(global, *flags); });
}

}  // namespace sl
