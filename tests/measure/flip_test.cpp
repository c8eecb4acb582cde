// SPDX-License-Identifier: MIT
#include "engine/measure/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "engine/core/error.h"
#include "engine/measure/flip_colour.h"
#include "engine/measure/metrics.h"
#include "tests/measure/slow_flip.h"

namespace sl {
namespace {

Image field(std::uint32_t width, std::uint32_t height, vec3 colour) {
    Image image(width, height, 3);
    for (std::size_t i = 0; i < image.data.size(); ++i) image.data[i] = colour[static_cast<int>(i % 3)];
    return image;
}

Image noise(std::uint32_t width, std::uint32_t height, unsigned seed) {
    Image image(width, height, 3);
    std::mt19937 random(seed);
    for (float& value : image.data) value = static_cast<float>(random() % 256) / 255.0f;
    return image;
}

float largest(const Flip& flip) {
    return *std::ranges::max_element(flip.map.data);
}

TEST(Flip, EqualPicturesDoNotDiffer) {
    const Image picture = noise(17, 5, 1);
    const Flip result = flip(picture, picture);
    EXPECT_EQ(result.mean, 0.0);
    EXPECT_EQ(largest(result), 0.0f);
    EXPECT_EQ(result.map.width, 17u);
    EXPECT_EQ(result.map.height, 5u);
    EXPECT_EQ(result.map.channels, 1u);
}

TEST(Flip, BlackAgainstWhiteByHand) {
    // Plain fields have no features and pass the filters as they are. HyAB = |0 − 100| = 100; 100^0.7 = 25.119.
    // Green is Lab (87.74, −86.18, 83.18), blue (32.30, 79.19, −107.86); with the Hunt factor 0.01 L:
    // (87.74, −75.61, 72.98) and (32.30, 25.57, −34.84). HyAB = 55.44 + √(101.18² + 107.82²) = 203.3; ^0.7 = 41.276.
    // Knee at 0.4 · 41.276 = 16.510: 0.95 + (25.119 − 16.510) / (41.276 − 16.510) · 0.05 = 0.96738.
    const Flip result = flip(field(12, 7, vec3(0)), field(12, 7, vec3(1)));
    EXPECT_NEAR(result.mean, 0.96738, 2e-5);
    for (const float value : result.map.data) EXPECT_NEAR(value, 0.96738f, 2e-5f);
}

TEST(Flip, GreenAgainstBlueIsTheEndOfTheScale) {
    EXPECT_NEAR(flip(field(4, 4, {0, 1, 0}), field(4, 4, {0, 0, 1})).mean, 1.0, 1e-5);
}

TEST(Flip, TwoGreysByHand) {
    // sRGB 0.5 is 0.21404 linear: L = 116 · 0.21404^⅓ − 16 = 53.389. Against black: 53.389^0.7 = 16.190, under the
    // knee: 0.95 · 16.190 / 16.510 = 0.9316.
    EXPECT_NEAR(flip(field(3, 3, vec3(0.5f)), field(3, 3, vec3(0))).mean, 0.9316, 2e-4);
}

TEST(Flip, IsWhatTheFormulasSayTakenLiterally) {
    for (const float pixels_per_degree : {67.0f, 30.0f, 11.0f}) {
        const Image a = noise(9, 9, 7), b = noise(9, 9, 8);
        const Flip result = flip(a, b, {}, pixels_per_degree);
        for (const uvec2 p : {uvec2(0, 0), uvec2(4, 4), uvec2(8, 2), uvec2(3, 8)}) {
            const double expected =
                slow::flip(a, b, static_cast<double>(pixels_per_degree), static_cast<int>(p.x), static_cast<int>(p.y));
            EXPECT_NEAR(*result.map.pixel(p.x, p.y), expected, 1e-4)
                << pixels_per_degree << " at " << p.x << ", " << p.y;
        }
    }
}

TEST(Flip, FindsAnEdgeAsTheFormulasDo) {
    // A white half against grey: differs in colour and in an edge.
    Image a = field(9, 9, vec3(0.4f));
    const Image b = a;
    for (std::uint32_t y = 0; y < 9; ++y) std::fill(a.pixel(5, y), a.pixel(5, y) + 12, 1.0f);
    const Flip result = flip(a, b);
    for (std::uint32_t x = 0; x < 9; ++x) {
        // Far from the edge the difference is next to nothing, and its power of 0.7 enlarges float's rounding.
        EXPECT_NEAR(*result.map.pixel(x, 4), slow::flip(a, b, 67.0, static_cast<int>(x), 4), 3e-4) << x;
    }
}

TEST(Flip, DoesNotDependOnWhichOfTheTwoIsTheReference) {
    const Image a = noise(20, 10, 1), b = noise(20, 10, 2);
    EXPECT_EQ(flip(a, b).map.data, flip(b, a).map.data);
}

TEST(Flip, GrowsWithContrast) {
    double before = 0.0;
    for (const float step : {0.01f, 0.05f, 0.1f, 0.3f, 0.6f}) {
        Image dotted = field(16, 16, vec3(0.4f));
        std::fill_n(dotted.pixel(8, 8), 3, 0.4f + step);
        const double now = flip(dotted, field(16, 16, vec3(0.4f))).mean;
        EXPECT_GT(now, before);
        before = now;
    }
}

TEST(Flip, ADotIsSeenLessWhereItsPixelIsSmaller) {
    Image dotted = field(64, 64, vec3(0.5f));
    std::fill_n(dotted.pixel(32, 32), 3, 1.0f);
    float before = 2.0f;
    for (const float pixels_per_degree : {20.0f, 40.0f, 67.0f, 134.0f}) {
        const float now = largest(flip(dotted, field(64, 64, vec3(0.5f)), {}, pixels_per_degree));
        EXPECT_LT(now, before) << pixels_per_degree;
        before = now;
    }
    EXPECT_GT(before, 0.0f);
}

TEST(Flip, StaysBetweenZeroAndOne) {
    const Flip result = flip(noise(40, 30, 3), field(40, 30, {1, 0, 1}));
    EXPECT_GE(*std::ranges::min_element(result.map.data), 0.0f);
    EXPECT_LE(largest(result), 1.0f);
}

TEST(Flip, MaskedPixelsNeitherCountNorBleed) {
    Image a = field(16, 16, vec3(0.5f)), b = a;
    std::vector<float> mask(256, 1.0f);
    for (std::uint32_t y = 0; y < 16; ++y) {
        for (std::uint32_t x = 8; x < 16; ++x) {
            mask[y * 16 + x] = 0.0f;
            std::fill_n(a.pixel(x, y), 3, std::numeric_limits<float>::quiet_NaN());
        }
    }
    EXPECT_EQ(flip(a, b, mask).mean, 0.0);
    EXPECT_THROW(flip(a, b), Error);
    std::fill_n(a.pixel(0, 0), 3, 1.0f);
    const Flip result = flip(a, b, mask);
    EXPECT_EQ(result.mean, masked_mean(result.map, mask));
    EXPECT_GT(result.mean, masked_mean(result.map, {}));
}

TEST(FlipColour, WhiteBlackAndBack) {
    EXPECT_NEAR(glm::distance(opponent_from_linear(vec3(1)), vec3(100, 0, 0)), 0.0f, 1e-3f);
    EXPECT_NEAR(glm::distance(opponent_from_linear(vec3(0)), vec3(-16, 0, 0)), 0.0f, 1e-3f);
    const vec3 colour(0.2f, 0.7f, 0.4f);
    EXPECT_NEAR(glm::distance(linear_from_opponent(opponent_from_linear(colour)), colour), 0.0f, 1e-5f);
}

}  // namespace
}  // namespace sl
