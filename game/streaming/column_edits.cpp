// SPDX-License-Identifier: MIT
#include "game/streaming/column_edits.h"

namespace sl {

void ColumnEdits::set(ivec3 cell, Block block) {
    columns_[column_of(cell)][{cell.x, cell.y, cell.z}] = block;
}

std::vector<CellEdit> ColumnEdits::around(ivec2 column) const {
    const ivec2 low = column_low(column) - 1, high = column_low(column + 1) + 1;
    std::vector<CellEdit> edits;
    for (const ivec2 neighbour : columns_round(column, 1)) {
        const auto found = columns_.find(neighbour);
        if (found == columns_.end()) continue;
        for (const auto& [cell, block] : found->second) {
            const ivec2 at(cell[0], cell[2]);
            if (glm::all(glm::greaterThanEqual(at, low)) && glm::all(glm::lessThan(at, high))) edits.push_back({{cell[0], cell[1], cell[2]}, block});
        }
    }
    return edits;
}

}  // namespace sl
