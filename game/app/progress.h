// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <string>

namespace sl {

/// A line on standard error that tells how far a long work is and how long it will still take; shown only once the
/// work has run for a second, and only on a terminal or when the share has grown by a tenth.
class Progress {
  public:
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// done of total units are finished; `note` is shown beside.
    void update(std::size_t done, std::size_t total, const std::string& note = {});
    /// Takes the line off a terminal, before something else is printed.
    void clear();

  private:
    using Clock = std::chrono::steady_clock;
    std::string what_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point shown_at_ = start_;
    double shown_share_ = 0.0;
    bool terminal_ = false;
    bool shown_ = false;
};

}  // namespace sl
