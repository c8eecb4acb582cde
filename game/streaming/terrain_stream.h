// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "game/streaming/column_jobs.h"

namespace sl {

/// What is there of an endless terrain; a component that stream_terrain puts beside its VoxelContent.
struct TerrainStream {
    Handle<VoxelVolume> volume;  ///< the content that it fills
    std::shared_ptr<const EndlessTerrain> terrain;
    ColumnSet loaded;
    ColumnEdits edits;
    std::unique_ptr<ColumnJobs> jobs;
    /// Round which column, and how far, all is there and nothing more; none while some is missing.
    std::optional<std::pair<ivec2, int>> whole;

    bool is_loaded(ivec2 column) const { return loaded.contains(column); }
    /// Keeps a block that was set, for when its column comes again.
    void keep(ivec3 cell, Block block);
};

/// How much of endless terrains is there, and how it comes; a resource.
struct TerrainView {
    double distance = 96.0;    ///< m; where a player has chosen, PictureSettings::view_distance counts instead
    double least_rate = 20.0;  ///< frames per second, as ViewReach keeps them; likewise
    /// All that is in view is there at the end of the system, as pictures need it that must come out the same each time.
    /// Otherwise job threads bring it while the game goes on.
    bool at_once = true;
};

/// Keeps the columns round the active camera, and no others.
void stream_terrain(World& world);

/// Endless terrain as a plugin; goes after add_voxel_world, so that the first frame is whole. Needs a FrameClock when it runs.
void add_terrain_streaming(App& app);

}  // namespace sl
