// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "engine/render/gl/context.h"
#include "game/session.h"

namespace CLI {
class App;
}

namespace sl {

/// What a subcommand runs once the command line is understood; returns the program's exit code.
using Command = std::function<int()>;

/// Flags that every command has.
struct GlobalFlags {
    std::string context = "auto";
    std::string log_level = "info";
};

/// Each adds one subcommand and sets `chosen` when it was given. The flags outlive the parse.
void add_play_command(CLI::App& cli, const GlobalFlags& flags, Command& chosen);
void add_capture_command(CLI::App& cli, const GlobalFlags& flags, Command& chosen);
void add_tour_command(CLI::App& cli, const GlobalFlags& flags, Command& chosen);
void add_list_command(CLI::App& cli, const GlobalFlags& flags, Command& chosen);
void add_bench_command(CLI::App& cli, const GlobalFlags& flags, Command& chosen);
void add_reference_command(CLI::App& cli, Command& chosen);
void add_merge_command(CLI::App& cli, Command& chosen);
/// Needs no context, so no flags.
void add_compare_command(CLI::App& cli, Command& chosen);

/// The flags --scene, --gi and --set that several commands share.
void add_scene_flags(CLI::App& command, SceneChoice& choice);

/// "640x360" to width and height. Throws Error stating the limits.
uvec2 parse_size(const std::string& text);

/// What happens without a subcommand: the window where there is a display, else the tour.
bool has_display();

}  // namespace sl
