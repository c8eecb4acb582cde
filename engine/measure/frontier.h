// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace sl {

/// What something costs and how wrong it is.
struct CostError {
    double cost = 0.0, error = 0.0;
};

/// Indices of the points that no other beats in both cost and error (Pareto), by rising cost; of equal ones the first.
/// Points that are not finite are never among them.
std::vector<std::size_t> frontier(const std::vector<CostError>& points);

}  // namespace sl
