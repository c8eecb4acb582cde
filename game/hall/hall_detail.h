// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace sl {

/// How finely curved things are cut: twice as much has about twice as many triangles.
class HallDetail {
  public:
    explicit HallDetail(double amount) : root_(std::sqrt(amount)) {}

    /// Along one side of a surface: as many where the amount is 1, and never fewer than `least`.
    int steps(int usual, int least) const { return std::max(least, static_cast<int>(std::lround(root_ * usual))); }

  private:
    double root_;
};

}  // namespace sl
