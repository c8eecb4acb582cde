// SPDX-License-Identifier: MIT
#include "game/streaming/view_reach.h"

#include <gtest/gtest.h>

namespace sl {
namespace {

constexpr double rate = 15.0;

/// So many seconds of frames that all take equally long.
void play(ViewReach& reach, double seconds, double frame, double least_rate = rate) {
    for (double passed = 0.0; passed < seconds; passed += frame) reach.follow(frame, least_rate);
}

TEST(ViewReach, QuickFramesShowAll) {
    ViewReach reach;
    play(reach, 60.0, 0.06);
    EXPECT_EQ(reach.share(), 1.0);
}

TEST(ViewReach, SlowFramesShowLessButNeverTooLittle) {
    ViewReach reach;
    play(reach, 1.0, 0.1);
    EXPECT_EQ(reach.share(), 1.0) << "a moment is no reason";
    play(reach, 3.0, 0.1);
    EXPECT_LT(reach.share(), 1.0);
    EXPECT_GT(reach.share(), ViewReach::least);
    play(reach, 120.0, 0.1);
    EXPECT_EQ(reach.share(), ViewReach::least);
}

TEST(ViewReach, WhatIsQuickEnoughStaysAndWhatIsMuchQuickerGrows) {
    ViewReach reach;
    play(reach, 4.0, 0.1);
    const double less = reach.share();
    play(reach, 60.0, 0.06);
    EXPECT_EQ(reach.share(), less) << "a step more might be too slow again";
    play(reach, 120.0, 0.02);
    EXPECT_EQ(reach.share(), 1.0);
}

TEST(ViewReach, OneLongFrameIsNoReason) {
    ViewReach reach;
    play(reach, 10.0, 0.05);
    reach.follow(0.2, rate);
    play(reach, 10.0, 0.05);
    EXPECT_EQ(reach.share(), 1.0);
}

TEST(ViewReach, ARestOrNoRateChangesNothingOrShowsAll) {
    ViewReach reach;
    play(reach, 120.0, 0.1);
    for (int frame = 0; frame < 1000; ++frame) reach.follow(0.0, rate);
    EXPECT_EQ(reach.share(), ViewReach::least);
    reach.follow(0.1, 0.0);
    EXPECT_EQ(reach.share(), 1.0);
    play(reach, 120.0, 0.1, 0.0);
    EXPECT_EQ(reach.share(), 1.0);
}

}  // namespace
}  // namespace sl
