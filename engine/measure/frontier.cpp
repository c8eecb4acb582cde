// SPDX-License-Identifier: MIT
#include "engine/measure/frontier.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace sl {

std::vector<std::size_t> frontier(const std::vector<CostError>& points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isfinite(points[i].cost) && std::isfinite(points[i].error)) order.push_back(i);
    }
    std::ranges::sort(order, {}, [&](std::size_t i) { return std::tuple(points[i].cost, points[i].error, i); });
    std::vector<std::size_t> result;
    double best = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order) {
        if (points[i].error >= best) continue;
        best = points[i].error;
        result.push_back(i);
    }
    return result;
}

}  // namespace sl
