// SPDX-License-Identifier: MIT
#include "game/app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace sl {

Progress::Progress(std::string what) : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (shown_ && terminal_) fmt::print(stderr, "\r\x1b[K");
}

void Progress::update(std::size_t done, std::size_t total) {
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
    fmt::print(stderr, "{}{}: {:.0f} %, about {:.0f} s left{}", terminal_ ? "\r\x1b[K" : "", what_, 100.0 * share, left,
               terminal_ ? "" : "\n");
    std::fflush(stderr);
}

}  // namespace sl
