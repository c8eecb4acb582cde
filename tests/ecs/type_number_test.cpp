// SPDX-License-Identifier: MIT
#include "engine/ecs/type_number.h"

#include <gtest/gtest.h>

namespace sl {
namespace {

struct Fruit;
struct Tool;

TEST(TypeNumber, counts_each_family_from_zero_and_stays) {
    EXPECT_EQ((type_number<Fruit, int>()), 0u);
    EXPECT_EQ((type_number<Fruit, float>()), 1u);
    EXPECT_EQ((type_number<Tool, float>()), 0u);
    EXPECT_EQ((type_number<Fruit, int>()), 0u);
}

}  // namespace
}  // namespace sl
