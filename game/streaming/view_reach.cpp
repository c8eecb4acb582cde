// SPDX-License-Identifier: MIT
#include "game/streaming/view_reach.h"

#include <algorithm>

namespace sl {

namespace {

constexpr double step = 0.87;          ///< factor on the share: a column or two
constexpr double time_of_mean = 3.0;    ///< s
constexpr double time_to_tell = 2.0;    ///< s until the mean tells what a step has brought
constexpr double time_to_trust = 10.0;  ///< s for which frames are quick before more is shown
/// Frames so much quicker than they must be stay quick enough when a step more is shown.
constexpr double quick = 0.6;

}  // namespace

void ViewReach::follow(double seconds, double least_rate) {
    if (seconds <= 0.0) return;
    mean_ = mean_ == 0.0 ? seconds : mean_ + std::min(seconds / time_of_mean, 1.0) * (seconds - mean_);
    since_ += seconds;
    const double most = least_rate > 0.0 ? 1.0 / least_rate : 1e9;
    double share = share_;
    if (mean_ > most && since_ >= time_to_tell) share = std::max(least, share_ * step);
    if (mean_ < quick * most && since_ >= time_to_trust) share = std::min(1.0, share_ / step);
    if (least_rate <= 0.0) share = 1.0;
    if (share == share_) return;
    share_ = share;
    // What frames took before says nothing of those to come.
    since_ = mean_ = 0.0;
}

}  // namespace sl
