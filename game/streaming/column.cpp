// SPDX-License-Identifier: MIT
#include "game/streaming/column.h"

#include <algorithm>
#include <tuple>

namespace sl {

std::vector<ivec2> columns_round(ivec2 centre, int radius) {
    std::vector<ivec2> columns;
    for (int z = -radius; z <= radius; ++z) {
        for (int x = -radius; x <= radius; ++x) {
            if (x * x + z * z <= radius * radius) columns.push_back(centre + ivec2(x, z));
        }
    }
    // The rest of the tuple makes the order the same on every machine.
    std::ranges::sort(columns, {}, [&](ivec2 column) { return std::tuple(distance_squared(column, centre), column.y, column.x); });
    return columns;
}

}  // namespace sl
