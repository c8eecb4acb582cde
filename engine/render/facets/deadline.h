// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>

namespace sl {

/// When the time of a frame is up.
class Deadline {
  public:
    /// 0 or less: never.
    explicit Deadline(double seconds) : seconds_(seconds) {}

    /// There is so many times as much time in all.
    void extend(double times) { seconds_ *= times; }
    /// There is so much left, s, whatever was spent.
    void leave(double seconds) {
        if (!none()) seconds_ = std::max(seconds_, spent() + seconds);
    }
    bool none() const { return seconds_ <= 0.0; }
    /// Whether more than this share of the time is spent.
    bool passed(double share = 1.0) const {
        return !none() && spent() > share * seconds_;
    }

  private:
    double spent() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double seconds_;
};

}  // namespace sl
