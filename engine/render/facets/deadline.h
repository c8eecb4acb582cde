// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

namespace sl {

/// When the time of a frame is up.
class Deadline {
  public:
    /// 0 or less: never.
    explicit Deadline(double seconds) : seconds_(seconds) {}

    /// There is so many times as much time in all.
    void extend(double times) { seconds_ *= times; }
    bool none() const { return seconds_ <= 0.0; }
    /// Whether more than this share of the time is spent.
    bool passed(double share = 1.0) const {
        return !none() && std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() > share * seconds_;
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double seconds_;
};

}  // namespace sl
