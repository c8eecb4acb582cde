// SPDX-License-Identifier: MIT
#pragma once

#include <unordered_set>

#include "game/voxel/voxel_volume.h"

namespace sl {

// A column is all chunks above each other. Its name is their key without the height.

inline ivec2 column_of(ivec3 cell) {
    const ivec3 key = chunk_key_of(cell);
    return {key.x, key.z};
}
/// The blocks [low, low + chunk_size) in x and z are a column's.
inline ivec2 column_low(ivec2 column) {
    return column * chunk_size;
}

struct ColumnHash {
    std::size_t operator()(ivec2 column) const { return IvecHash()({column.x, 0, column.y}); }
};
using ColumnSet = std::unordered_set<ivec2, ColumnHash>;

/// In columns, squared.
inline int distance_squared(ivec2 a, ivec2 b) {
    const ivec2 away = a - b;
    return away.x * away.x + away.y * away.y;
}

/// All columns not farther than `radius` from `centre`, nearest first.
std::vector<ivec2> columns_round(ivec2 centre, int radius);

}  // namespace sl
