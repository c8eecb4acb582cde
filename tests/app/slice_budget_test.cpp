// SPDX-License-Identifier: MIT
#include "game/app/slice_budget.h"

#include <gtest/gtest.h>

#include "game/app/hud.h"

namespace sl {
namespace {

TEST(SliceBudget, SettlesWhereFramesTakeLessThanATenthOfASecond) {
    for (const double seconds_per_slice : {0.0001, 0.003, 0.02}) {
        SliceBudget budget;
        double longest = 0.0;
        for (int i = 0; i < 200; ++i) {
            const double seconds = 0.01 + seconds_per_slice * budget.slices();
            longest = std::max(longest, seconds);
            budget.frame_took(seconds, true);
        }
        EXPECT_LT(longest, 0.11);
        EXPECT_GT(longest, 0.025);
    }
}

TEST(SliceBudget, NeverStops) {
    SliceBudget budget;
    for (int i = 0; i < 50; ++i) budget.frame_took(3.0, true);
    EXPECT_EQ(budget.slices(), 1u);
}

TEST(SliceBudget, LearnsNothingFromFramesWithoutWork) {
    SliceBudget budget;
    for (int i = 0; i < 50; ++i) budget.frame_took(0.001, false);
    EXPECT_EQ(budget.slices(), 1u);
}

TEST(FrameMeter, ComesToAConstantFrameTimeAndSmoothsOneThatIsNot) {
    FrameMeter meter;
    for (int i = 0; i < 300; ++i) meter.add(0.010);
    EXPECT_NEAR(meter.milliseconds(), 10.0, 1e-6);
    meter.add(0.020);
    EXPECT_LT(meter.milliseconds(), 11.0);
    meter.add(5.0);
    EXPECT_NEAR(meter.milliseconds(), 5000.0, 1e-6);
}

}  // namespace
}  // namespace sl
