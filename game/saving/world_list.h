// SPDX-License-Identifier: MIT
#pragma once

#include "game/saving/world_file.h"

namespace sl {

/// A world file in the list of worlds.
struct WorldEntry {
    std::filesystem::path path;
    std::string name;   ///< the file's, without its ending
    std::string scene;  ///< with which it began
    std::uintmax_t bytes = 0;
    std::filesystem::file_time_type last_played;
    bool open = false;  ///< in this game
    std::string fault;  ///< why it cannot be played; empty where it can
};

/// The worlds of a folder, the last played first. No file is written to. `open` is the one that this game has open, or null.
std::vector<WorldEntry> list_worlds(const std::filesystem::path& folder, const WorldFile* open);

/// Whether a path is that of a world, by its ending.
bool is_world_file(const std::filesystem::path& path);

/// Where a world of that name lies, or would.
std::filesystem::path world_path(const std::filesystem::path& folder, const std::string& name);

/// Why there can be no new world of that name; empty where there can.
std::string fault_of_name(const std::filesystem::path& folder, const std::string& name);

/// For ever. Throws Error for what is no sound world, or is open anywhere.
void delete_world(const std::filesystem::path& path);

}  // namespace sl
