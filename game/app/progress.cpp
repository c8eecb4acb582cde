// SPDX-License-Identifier: MIT
#include "game/app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace sl {

Progress::Progress(std::string what) : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() { clear(); }

void Progress::clear() {
    if (std::exchange(shown_, false) && terminal_) fmt::print(stderr, "\r\x1b[K");
}

/// "50 s", "12 min" or "3.5 h".
static std::string duration_text(double seconds) {
    if (seconds < 90.0) return fmt::format("{:.0f} s", seconds);
    return seconds < 5400.0 ? fmt::format("{:.0f} min", seconds / 60.0) : fmt::format("{:.1f} h", seconds / 3600.0);
}

void Progress::update(std::size_t done, std::size_t total, const std::string& note) {
    const auto now = Clock::now();
    const std::chrono::duration<double> passed = now - start_;
    const std::chrono::duration<double> since_shown = now - shown_at_;
    if (passed.count() < 1.0 || total == 0 || done == 0) return;
    const double share = static_cast<double>(done) / static_cast<double>(total);
    if (terminal_ ? since_shown.count() < 0.2 : share < shown_share_ + 0.1) return;
    shown_at_ = now;
    shown_share_ = share;
    shown_ = true;
    const double left = passed.count() * (1.0 - share) / share;
    fmt::print(stderr, "{}{}: {:.0f} %{}{}, about {} left{}", terminal_ ? "\r\x1b[K" : "", what_, 100.0 * share, note.empty() ? "" : ", ", note,
               duration_text(left), terminal_ ? "" : "\n");
    std::fflush(stderr);
}

}  // namespace sl
