// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <string_view>
#include <utility>
#include <vector>

namespace sl {

/// What a frame's processor time went into, part after part.
class WorkTimes {
  public:
    /// One of them.
    struct Part {
        std::string_view name;  ///< a literal
        double milliseconds = 0.0;
    };

    /// Forgets all parts; the first one starts now.
    void begin() {
        parts_.clear();
        since_ = Watch::now();
    }
    /// A part is done: what has passed since the last one was is its time, added to what it had.
    void done(std::string_view name) {
        const auto now = Watch::now();
        const std::chrono::duration<double, std::milli> passed = now - std::exchange(since_, now);
        const auto part = std::ranges::find(parts_, name, &Part::name);
        if (part != parts_.end()) {
            part->milliseconds += passed.count();
        } else {
            parts_.push_back({name, passed.count()});
        }
    }
    const std::vector<Part>& parts() const { return parts_; }

  private:
    using Watch = std::chrono::steady_clock;
    std::vector<Part> parts_;
    Watch::time_point since_ = Watch::now();
};

}  // namespace sl
