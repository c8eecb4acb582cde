// SPDX-License-Identifier: MIT
#include "engine/render/pass_times.h"

#include <gmock/gmock.h>

namespace sl {
namespace {

const std::vector<gl::SpanTime> frame{{"gbuffer", "", 1.0},     {"shadow_map_0", "", 2.0}, {"rsm_0", "gi", 4.0},
                                      {"rsm_1", "gi", 8.0},     {"irradiance", "gi", 16.0}, {"compose", "", 32.0}};

TEST(PassTimes, NumberedPassesOfOneKindAddUpInOrder) {
    std::vector<std::pair<std::string, double>> rows;
    for (const gl::SpanTime& row : pass_times(frame)) rows.emplace_back(row.name, row.milliseconds);
    EXPECT_THAT(rows, testing::ElementsAre(std::pair("gbuffer", 1.0), std::pair("shadow_map", 2.0), std::pair("rsm", 12.0),
                                           std::pair("irradiance", 16.0), std::pair("compose", 32.0)));
}

TEST(PassTimes, GiIsWhatTheMethodAskedFor) {
    EXPECT_EQ(gi_milliseconds(frame), 28.0);
    EXPECT_EQ(gi_milliseconds(pass_times(frame)), 28.0);
}

}  // namespace
}  // namespace sl
