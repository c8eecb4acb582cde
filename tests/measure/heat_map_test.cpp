// SPDX-License-Identifier: MIT
#include "engine/measure/heat_map.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/measure/flip_colour.h"
#include "engine/measure/pixel_text.h"

namespace sl {
namespace {

float lightness(float value) {
    return hunt_lab_from_linear(linear_from_srgb(heat_colour(value))).x;
}

vec3 colour_at(const Image& picture, std::uint32_t x, std::uint32_t y) {
    const float* p = picture.pixel(x, y);
    return {p[0], p[1], p[2]};
}

TEST(HeatColour, LightnessRisesEvenly) {
    const float dark = lightness(0.0f), bright = lightness(1.0f);
    EXPECT_GT(bright - dark, 95.0f);
    float before = -1.0f;
    for (int i = 0; i <= 200; ++i) {
        const float t = static_cast<float>(i) / 200.0f, now = lightness(t);
        EXPECT_GT(now, before) << t;
        EXPECT_NEAR(now, glm::mix(dark, bright, t), 1.5f) << t;
        before = now;
    }
}

TEST(HeatColour, StaysOnTheRamp) {
    EXPECT_EQ(heat_colour(-1.0f), heat_colour(0.0f));
    EXPECT_EQ(heat_colour(7.0f), heat_colour(1.0f));
}

TEST(HeatMap, ShowsValuesInPlaceAndALegendBelow) {
    Image map(300, 40, 1);
    map.data[5] = 0.25f;
    map.data[6] = 0.5f;
    map.data[7] = std::numeric_limits<float>::infinity();
    const Image picture = heat_map(map, {}, {.title = "error", .top = 0.5, .percent = true});
    EXPECT_EQ(picture.width, 300u);
    EXPECT_GT(picture.height, 60u);
    EXPECT_EQ(colour_at(picture, 0, 0), heat_colour(0.0f));
    EXPECT_EQ(colour_at(picture, 5, 0), heat_colour(0.5f));
    EXPECT_EQ(colour_at(picture, 6, 0), heat_colour(1.0f));
    EXPECT_EQ(colour_at(picture, 7, 0), heat_colour(1.0f));
    for (const float value : picture.data) EXPECT_TRUE(value >= 0.0f && value <= 1.0f);
}

TEST(HeatMap, IgnoredPixelsAreGreyAndNoColourOfTheRamp) {
    const Image map(2, 1, 1);
    const vec3 ignored = colour_at(heat_map(map, {1, 0}, {.title = "error"}), 1, 0);
    EXPECT_EQ(ignored.x, ignored.y);
    EXPECT_EQ(ignored.y, ignored.z);
    for (int i = 0; i <= 100; ++i)
        EXPECT_GT(glm::distance(heat_colour(static_cast<float>(i) / 100.0f), ignored), 0.15f);
}

TEST(HeatMap, ASmallMapGetsAWholeLegend) {
    const Image picture = heat_map(Image(1, 1, 1), {0.0f}, {.title = "relative error"});
    EXPECT_GE(picture.width, text_width("relative error") + text_width("not compared"));
}

TEST(SuggestedTop, IsRoundAndAboveAlmostAll) {
    Image map(1000, 1, 1);
    std::ranges::fill(map.data, 0.13f);
    EXPECT_DOUBLE_EQ(suggested_top(map, {}), 0.2);
    std::fill_n(map.data.begin(), 40, 80.0f);
    EXPECT_DOUBLE_EQ(suggested_top(map, {}), 0.2);
    std::fill_n(map.data.begin(), 60, 80.0f);
    EXPECT_DOUBLE_EQ(suggested_top(map, {}), 100.0);
    EXPECT_EQ(suggested_top(Image(3, 1, 1), {}), 1.0);
    std::ranges::fill(map.data, std::numeric_limits<float>::infinity());
    EXPECT_EQ(suggested_top(map, {}), 1.0);
}

TEST(PixelText, DrawsADigitByHand) {
    Image picture(12, 9, 3);
    draw_text(picture, 1, 1, 1, vec3(1), "1");
    // The foot of the 1: three dots in the middle of five, in the seventh row.
    for (std::uint32_t x = 0; x < 12; ++x) EXPECT_EQ(picture.pixel(x, 7)[0], x >= 2 && x <= 4 ? 1.0f : 0.0f) << x;
    EXPECT_EQ(text_width("12"), 11u);
    EXPECT_EQ(text_width(""), 0u);
}

TEST(PixelText, IsCutOffAtTheEdges) {
    Image picture(3, 3, 3);
    draw_text(picture, -2, -3, 2, vec3(1), "W%?");
    draw_text(picture, 100, 100, 1, vec3(1), "8");
    EXPECT_EQ(picture.data.size(), 27u);
}

}  // namespace
}  // namespace sl
