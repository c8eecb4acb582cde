// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/gl/context.h"
#include "game/app/flags.h"
#include "game/session.h"

namespace sl {

/// Flags that every command has.
struct GlobalFlags {
    std::string context = "auto";
    std::string log_level = "info";
    bool outside_files = false;
};

/// Each adds one subcommand. The flags outlive the parse.
void add_play_command(const Flags& program, const GlobalFlags& flags);
void add_capture_command(const Flags& program, const GlobalFlags& flags);
void add_tour_command(const Flags& program, const GlobalFlags& flags);
void add_list_command(const Flags& program, const GlobalFlags& flags);
void add_bench_onoff_command(const Flags& bench, const GlobalFlags& flags);
void add_bench_changes_command(const Flags& bench, const GlobalFlags& flags);
void add_bench_day_command(const Flags& bench, const GlobalFlags& flags);
void add_bench_growth_command(const Flags& bench, const GlobalFlags& flags);
void add_bench_motion_command(const Flags& bench, const GlobalFlags& flags);
void add_bench_flight_command(const Flags& bench, const GlobalFlags& flags);
void add_bench_gi_command(const Flags& bench, const GlobalFlags& flags);
void add_bench_models_command(const Flags& bench, const GlobalFlags& flags);
void add_bench_rays_command(const Flags& bench);
void add_export_command(const Flags& program);
void add_generate_command(const Flags& program);
void add_inspect_command(const Flags& program);
void add_schema_command(const Flags& program);
void add_reference_command(const Flags& program);
void add_merge_command(const Flags& program);
/// Needs no context, so no flags.
void add_compare_command(const Flags& program);

/// The program with all its commands. `flags` outlives it.
Program whole_program(GlobalFlags& flags);

inline constexpr const char* scene_flag_help = "Scene by name (see `secondlight list scenes`), or path of a scene file or of a model (.gltf, .glb, .vox); the flag may be left out";
/// The flags --scene, --camera, --gi and --set that several commands share.
void add_scene_flags(const Flags& command, SceneChoice& choice);
/// --gi and --set alone.
void add_setting_flags(const Flags& command, SceneChoice& choice);

/// Throws Error where a file's name does not end in its format, or its folder is missing; an empty name is fine. Before long
/// work, not after.
void check_output(const std::string& file, const char* extension);

/// "640x360" to width and height. Throws Error stating the limits.
uvec2 parse_size(const std::string& text);

/// Whole numbers with a separator between them: "0,0,320,180" or "0:128". Throws Error that tells `form` where the text is
/// something else. Of std::uint32_t and std::int32_t.
template <class Number>
std::vector<Number> whole_numbers(const std::string& text, char separator, std::size_t count, const char* flag, const char* form);

/// What happens without a subcommand: the window where there is a display, else the tour.
bool has_display();

}  // namespace sl
