// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/app.h"
#include "game/saving/world_file.h"
#include "game/voxel_content.h"

namespace sl {

/// The world file of this game; a resource.
struct SavedWorld {
    std::unique_ptr<WorldFile> file;
    /// A voxel entity with all that was built in it, which goes in again where its blocks are made anew: the editor
    /// may delete the entity and bring back another one of its name.
    struct Volume {
        Entity entity;
        std::string name;
        std::map<std::array<int, 3>, Block> built;
        Handle<VoxelVolume> filled;  ///< holds it already
    };
    std::vector<Volume> volumes;  ///< by their numbers in the file
    double unsaved = 0.0;  ///< s since player and day were last looked at
    std::map<std::string, std::string> texts;  ///< of them, as last saved
};

/// Where worlds lie that nobody gave a path: $XDG_DATA_HOME or ~/.local/share, and there secondlight/worlds; without a home,
/// in the folder for temporary files.
std::filesystem::path worlds_folder();

/// Puts what a world file holds into its scene, just opened, and saves what changes from then on: blocks that are set, and
/// where the player is, and the hour of the day.
void attach_world(App& app, std::unique_ptr<WorldFile> file);

/// Before another world takes the place of this one: saves where the player is now and waits until all is on disk. Throws Error
/// where that fails, for what was built would be lost.
void finish_world(World& world);

/// Hands what has changed to the world file; never waits for the disk.
void save_world(World& world);

}  // namespace sl
