// SPDX-License-Identifier: MIT
#include "game/streaming/column_build.h"

namespace sl {

BuiltColumn build_column(const EndlessTerrain& terrain, ivec2 column, float block_size, const std::vector<CellEdit>& edits) {
    VoxelVolume volume(block_size);
    // A block of the neighbours belongs to it: what they hide needs no face.
    terrain.fill(volume, column_low(column) - 1, column_low(column + 1) + 1);
    for (const CellEdit& edit : edits) volume.set(edit.cell, edit.block);
    BuiltColumn built{.column = column, .parts = {}};
    for (const ivec3 key : volume.chunk_keys()) {
        if (ivec2(key.x, key.z) != column) continue;
        built.parts.push_back({*volume.chunk(key), meshed_chunk(volume, key)});
    }
    return built;
}

}  // namespace sl
