// SPDX-License-Identifier: MIT
#include "engine/core/work_times.h"

#include <gtest/gtest.h>

#include <thread>

namespace sl {
namespace {

TEST(WorkTimes, EachPartGetsWhatPassedSinceTheOneBefore) {
    using namespace std::chrono_literals;
    WorkTimes times;
    times.begin();
    times.done("first");
    std::this_thread::sleep_for(2ms);
    times.done("second");
    times.done("first");
    std::this_thread::sleep_for(2ms);
    times.done("second");
    ASSERT_EQ(times.parts().size(), 2u);
    EXPECT_EQ(times.parts()[1].name, "second");
    EXPECT_GE(times.parts()[1].milliseconds, 4.0);
    times.begin();
    EXPECT_TRUE(times.parts().empty());
}

}  // namespace
}  // namespace sl
