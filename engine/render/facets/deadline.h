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

    /// There is so many times as much left. Not in all: a frame in which something else took long would grow by as many times that.
    void extend(double times) {
        if (!none()) seconds_ += (times - 1.0) * std::max(seconds_ - spent(), 0.0);
    }
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
