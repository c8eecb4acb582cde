// SPDX-License-Identifier: MIT
#include "engine/render/trace/samples.h"

#include <gtest/gtest.h>

#include <set>

namespace sl {
namespace {

/// How many cells of a grid of the unit square hold a point.
std::size_t cells_hit(std::uint32_t columns, std::uint32_t rows, std::uint32_t count, int dimension, uvec2 pixel) {
    std::set<std::pair<int, int>> cells;
    for (std::uint32_t i = 0; i < count; ++i) {
        SampleSequence samples(5, pixel, i);
        for (int d = 0; d < dimension; ++d) (void)samples.pair();
        const vec2 p = samples.pair();
        EXPECT_TRUE(p.x >= 0.0f && p.x < 1.0f && p.y >= 0.0f && p.y < 1.0f);
        cells.emplace(int(p.x * float(columns)), int(p.y * float(rows)));
    }
    return cells.size();
}

TEST(SampleSequence, EveryElementaryIntervalHoldsOnePoint) {
    // What makes a (0, 2)-sequence in base 2: 2^k points put one into each box of 2^-i by 2^-(k-i), for every i.
    for (const int dimension : {0, 1, 7}) {
        for (std::uint32_t split = 0; split <= 6; ++split) EXPECT_EQ(cells_hit(1u << split, 64u >> split, 64, dimension, {3, 9}), 64u) << dimension << ", " << split;
    }
}

TEST(SampleSequence, PixelsAndDimensionsDiffer) {
    const auto first = [](uvec2 pixel, int skip) {
        SampleSequence samples(1, pixel, 0);
        for (int i = 0; i < skip; ++i) (void)samples.pair();
        return samples.pair();
    };
    std::set<std::pair<float, float>> points;
    for (std::uint32_t x = 0; x < 8; ++x) {
        for (int d = 0; d < 8; ++d) points.emplace(first({x, 0}, d).x, first({x, 0}, d).y);
    }
    EXPECT_EQ(points.size(), 64u);
}

}  // namespace
}  // namespace sl
