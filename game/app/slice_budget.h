// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace sl {

/// How much of a slow method is done per frame, so that the window keeps answering: more while frames are
/// quick, less at once when one was slow.
class SliceBudget {
  public:
    std::uint32_t slices() const { return slices_; }

    /// `working`: whether the frame had sliced work to do; only such frames tell anything.
    void frame_took(double seconds, bool working) {
        if (seconds > longest) {
            slices_ = std::max(slices_ / 2, 1u);
            quick_ = 0;
        } else if (working && seconds < longest / 2) {
            // A GPU is some frames behind; wait for it to show what the last raise has cost.
            if (++quick_ % patience == 0) slices_ = std::min(slices_ * 2, most);
        }
    }

  private:
    static constexpr double longest = 0.1;  // s
    static constexpr std::uint32_t most = 1u << 12;
    static constexpr int patience = 4;  // frames
    std::uint32_t slices_ = 1;
    int quick_ = 0;
};

}  // namespace sl
