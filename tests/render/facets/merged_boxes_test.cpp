// SPDX-License-Identifier: MIT
#include "engine/render/facets/merged_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace sl {
namespace {

Bounds cube_at(vec3 low) { return {low, low + 1.0f}; }

TEST(MergedBoxes, WhatLiesSideBySideIsOne) {
    const std::vector<Bounds> boxes = merged_boxes({cube_at({0, 0, 0}), cube_at({2, 0, 0}), cube_at({1, 0, 0})}, 8);
    ASSERT_EQ(boxes.size(), 1u);
    EXPECT_EQ(boxes[0].low, vec3(0, 0, 0));
    EXPECT_EQ(boxes[0].high, vec3(3, 1, 1));
}

TEST(MergedBoxes, WhatTouchesAtACornerStaysApart) {
    EXPECT_EQ(merged_boxes({cube_at({0, 0, 0}), cube_at({1, 1, 1})}, 8).size(), 2u);
}

TEST(MergedBoxes, ThereAreNoMoreThanAskedForAndTheyHoldAll) {
    std::vector<Bounds> cubes;
    for (int i = 0; i < 400; ++i) cubes.push_back(cube_at(vec3(7 * (i % 20), 0, 5 * (i / 20))));
    const std::vector<Bounds> boxes = merged_boxes(cubes, 6);
    EXPECT_LE(boxes.size(), 6u);
    for (const Bounds& cube : cubes) {
        EXPECT_TRUE(std::ranges::any_of(boxes, [&](const Bounds& box) { return box.contains(cube.low) && box.contains(cube.high); }));
    }
}

}  // namespace
}  // namespace sl
