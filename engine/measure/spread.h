// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

namespace sl {

/// Values over runs: smallest, quartiles, largest; all 0 of none.
struct Spread {
    double low = 0, first = 0, median = 0, third = 0, high = 0;
};

/// Quartiles by nearest rank; the values may come in any order.
inline Spread spread_of(std::vector<double> values) {
    if (values.empty()) return {};
    std::ranges::sort(values);
    const auto at = [&](double share) { return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)]; };
    return {values.front(), at(0.25), at(0.5), at(0.75), values.back()};
}

}  // namespace sl
