// SPDX-License-Identifier: MIT
#include "engine/measure/frontier.h"

#include <gmock/gmock.h>

#include <limits>

#include "engine/measure/spread.h"

namespace sl {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Frontier, KeepsWhatNothingBeats) {
    //                       beaten by 1          beaten by 3
    EXPECT_THAT(frontier({{2.0, 0.5}, {1.0, 0.4}, {4.0, 0.3}, {3.0, 0.1}, {9.0, 0.05}}), ElementsAre(1, 3, 4));
}

TEST(Frontier, OfEqualPointsTheFirst) { EXPECT_THAT(frontier({{1.0, 0.5}, {1.0, 0.5}}), ElementsAre(0)); }

TEST(Frontier, WhatIsNotFiniteIsLeftOut) {
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_THAT(frontier({{inf, 0.1}, {0.1, inf}, {std::nan(""), 0.1}}), IsEmpty());
    EXPECT_THAT(frontier({}), IsEmpty());
}

TEST(Spread, ByHand) {
    const Spread s = spread_of({5, 1, 4, 2, 3});
    EXPECT_THAT((std::vector<double>{s.low, s.first, s.median, s.third, s.high}), ElementsAre(1, 2, 3, 4, 5));
    EXPECT_EQ(spread_of({}).median, 0.0);
    EXPECT_EQ(spread_of({7}).high, 7.0);
}

}  // namespace
}  // namespace sl
