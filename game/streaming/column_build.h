// SPDX-License-Identifier: MIT
#pragma once

#include "game/streaming/column_edits.h"
#include "game/voxel/endless_terrain.h"
#include "game/voxel_chunks.h"

namespace sl {

/// All that the world needs to take in a column.
struct BuiltColumn {
    struct Part {
        Chunk blocks;
        MeshedChunk meshed;
    };
    ivec2 column{0};
    std::vector<Part> parts;  ///< from below to above
};

/// Makes and meshes a column. Depends on its arguments only, so any thread may do it; `edits` are ColumnEdits::around of it.
BuiltColumn build_column(const EndlessTerrain& terrain, ivec2 column, float block_size, const std::vector<CellEdit>& edits);

}  // namespace sl
