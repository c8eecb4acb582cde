// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <deque>
#include <span>
#include <string>
#include <vector>

#include "engine/render/gl/timer.h"

namespace sl {

/// What each pass took in the last frames.
class PassHistory {
  public:
    static constexpr std::size_t longest = 300;  ///< frames

    /// One frame more; the oldest is forgotten.
    void add(std::span<const gl::SpanTime> times);

    /// Every pass that ran in a remembered frame, in the order in which they came.
    const std::vector<std::string>& passes() const { return passes_; }
    std::size_t frames() const { return frames_.size(); }
    /// 0 where the pass did not run in that frame. Frame 0 is the oldest.
    float milliseconds(std::size_t frame, std::size_t pass) const;
    float sum(std::size_t frame) const;
    float largest_sum() const;

  private:
    void forget_passes_that_no_longer_run();

    std::vector<std::string> passes_;
    std::deque<std::vector<float>> frames_;  ///< ms by pass; a pass that came later is missing at the end
};

/// The history as areas on top of each other, the newest frame at the right, with a legend. The frame under the
/// mouse tells its numbers.
void draw_pass_history(const PassHistory& history);

}  // namespace sl
