// SPDX-License-Identifier: MIT
#include "editor/pass_history.h"

#include <algorithm>
#include <numeric>

namespace sl {

void PassHistory::add(std::span<const gl::SpanTime> times) {
    std::vector<float> frame(passes_.size());
    for (const gl::SpanTime& time : times) {
        const auto known = std::ranges::find(passes_, time.name);
        const auto pass = static_cast<std::size_t>(known - passes_.begin());
        if (known == passes_.end()) {
            passes_.push_back(time.name);
            frame.push_back(0.0f);
        }
        frame[pass] += static_cast<float>(time.milliseconds);
    }
    frames_.push_back(std::move(frame));
    if (frames_.size() > longest) frames_.pop_front();
    forget_passes_that_no_longer_run();
}

float PassHistory::milliseconds(std::size_t frame, std::size_t pass) const {
    return pass < frames_[frame].size() ? frames_[frame][pass] : 0.0f;
}

float PassHistory::sum(std::size_t frame) const {
    return std::accumulate(frames_[frame].begin(), frames_[frame].end(), 0.0f);
}

float PassHistory::largest_sum() const {
    float most = 0.0f;
    for (std::size_t frame = 0; frame < frames_.size(); ++frame) most = std::max(most, sum(frame));
    return most;
}

void PassHistory::forget_passes_that_no_longer_run() {
    for (std::size_t pass = passes_.size(); pass-- > 0;) {
        const auto ran = [&](const std::vector<float>& frame) { return pass < frame.size() && frame[pass] > 0.0f; };
        if (std::ranges::any_of(frames_, ran)) continue;
        passes_.erase(passes_.begin() + static_cast<std::ptrdiff_t>(pass));
        for (std::vector<float>& frame : frames_) {
            if (pass < frame.size()) frame.erase(frame.begin() + static_cast<std::ptrdiff_t>(pass));
        }
    }
}

}  // namespace sl
