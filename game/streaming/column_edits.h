// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <unordered_map>

#include "game/streaming/column.h"

namespace sl {

/// A block that somebody set.
struct CellEdit {
    ivec3 cell{0};
    Block block = Block::air;
};

/// All that was set in an endless terrain, found by column; it outlives the columns' blocks.
class ColumnEdits {
  public:
    void set(ivec3 cell, Block block);
    /// Those in a column and in the one block of its neighbours that its mesh depends on.
    std::vector<CellEdit> around(ivec2 column) const;

  private:
    std::unordered_map<ivec2, std::map<std::array<int, 3>, Block>, ColumnHash> columns_;
};

}  // namespace sl
