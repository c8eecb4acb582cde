// SPDX-License-Identifier: MIT
#include "engine/ecs/stage.h"

#include <gtest/gtest.h>

namespace sl {
namespace {

TEST(Stage, names_follow_the_order_of_a_frame) {
    EXPECT_EQ(stage_name(Stage::input), "input");
    EXPECT_EQ(stage_name(Stage::simulate), "simulate");
    EXPECT_EQ(stage_name(Stage::derive), "derive");
    EXPECT_EQ(stage_name(Stage::mesh), "mesh");
    EXPECT_EQ(stage_name(Stage::extract), "extract");
    EXPECT_EQ(stage_name(Stage::present), "present");
    EXPECT_EQ(stage_count, 6u);
}

}  // namespace
}  // namespace sl
