// SPDX-License-Identifier: MIT
#include "engine/measure/flicker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/core/error.h"

namespace sl {
namespace {

constexpr std::uint32_t width = 32, height = 16;
constexpr float above = 4.0f;  // m between the camera and the plane
constexpr float slope = 0.5f;  // of the view's upper edge
constexpr float pixel = 2.0f * slope * above / height;  // m on the plane

/// A camera that looks straight down on the plane y = 0; `right` is how many pixels' sides it stands to the right.
PathFrame plane_from(float right, float rise = 0.0f) {
    PathFrame frame{.view = {}, .depth = Image(width, height, 1), .normal = Image(width, height, 3), .value = Image(width, height, 3)};
    frame.view.camera_position = vec4(right * pixel, above, 0, 0.02f);
    frame.view.ray_forward = vec4(0, -1, 0, 1);
    frame.view.ray_right = vec4(slope * width / height, 0, 0, width);
    frame.view.ray_up = vec4(0, 0, -slope, height);
    for (float& depth : frame.depth.data) depth = 0.02f / (above - rise);
    for (std::size_t i = 0; i < frame.depth.data.size(); ++i) frame.normal.data[3 * i + 1] = 1.0f;
    return frame;
}

template <class Light>
void light(PathFrame& frame, Image PathFrame::*image, const Light& value) {
    frame.*image = Image(width, height, 3);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) std::fill_n((frame.*image).pixel(x, y), 3, value(seen_position(frame, {x, y})));
    }
}

std::vector<PathFrame> path(std::size_t count, float shift, const std::function<float(std::size_t, vec3)>& value) {
    std::vector<PathFrame> frames;
    for (std::size_t i = 0; i < count; ++i) {
        frames.push_back(plane_from(shift * static_cast<float>(i)));
        light(frames.back(), &PathFrame::value, [&](vec3 position) { return value(i, position); });
    }
    return frames;
}

TEST(FindPoint, IsTheInverseOfSeenPosition) {
    const PathFrame frame = plane_from(0.0f);
    const auto found = find_point(frame, seen_position(frame, {5, 7}), vec3(0, 1, 0));
    ASSERT_TRUE(found);
    float share = 0.0f;
    for (std::size_t i = 0; i < 4; ++i) {
        if (found->pixels[i] == 7 * width + 5) share += found->shares[i];
    }
    EXPECT_NEAR(share, 1.0f, 1e-3f);
}

TEST(FindPoint, AShiftByPartsOfAPixelIsBilinear) {
    // The camera moves to the right by a quarter of a pixel: the point is seen a quarter further to the left.
    const auto found = find_point(plane_from(0.25f), seen_position(plane_from(0.0f), {5, 7}), vec3(0, 1, 0));
    ASSERT_TRUE(found);
    float left = 0.0f, same = 0.0f;
    for (std::size_t i = 0; i < 4; ++i) {
        if (found->pixels[i] == 7 * width + 4) left += found->shares[i];
        if (found->pixels[i] == 7 * width + 5) same += found->shares[i];
    }
    EXPECT_NEAR(left, 0.25f, 1e-4f);
    EXPECT_NEAR(same, 0.75f, 1e-4f);
}

TEST(FindPoint, NotOutsideThePictureNorOnAnotherSurface) {
    const vec3 point = seen_position(plane_from(0.0f), {5, 7}), up(0, 1, 0);
    EXPECT_FALSE(find_point(plane_from(8.0f), point, up));
    EXPECT_FALSE(find_point(plane_from(0.0f, 0.1f), point, up)) << "a plane 10 cm above it";
    EXPECT_FALSE(find_point(plane_from(0.0f), point, vec3(1, 0, 0)));
    PathFrame sky = plane_from(0.0f);
    sky.depth = Image(width, height, 1);
    EXPECT_FALSE(find_point(sky, point, up));
    // One of the neighbours that count shows something else.
    PathFrame edge = plane_from(0.5f);
    *edge.depth.pixel(4, 7) = 0.02f / (above - 1.0f);
    EXPECT_FALSE(find_point(edge, point, up));
}

TEST(Flicker, LightThatStandsStillHasNone) {
    const Flicker still = flicker(path(5, 0.7f, [](std::size_t, vec3) { return 3.0f; }));
    const FlickerFigures figures = flicker_figures(still.deviation, still.mask);
    EXPECT_GT(figures.pixels, width * height / 2u);
    EXPECT_LT(figures.rms, 1e-6);
    EXPECT_LT(flicker_figures(still.change, still.mask).p99, 1e-6);
    // A gradient on the surface is no flicker either.
    const Flicker gradient = flicker(path(5, 0.7f, [](std::size_t, vec3 position) { return 10.0f + position.x - 2.0f * position.z; }));
    EXPECT_LT(flicker_figures(gradient.deviation, gradient.mask).rms, 1e-5);
}

TEST(Flicker, LightThatAlternatesByFrame) {
    // 1.2, 0.8, 1.2, 0.8: mean 1, variance 4 · 0.04 / 3, each step 0.4; over 1 plus 1 % of the middle frame's 1.2.
    const Flicker result = flicker(path(4, 0.3f, [](std::size_t frame, vec3) { return frame % 2 == 0 ? 1.2f : 0.8f; }));
    const std::size_t middle = height / 2 * width + width / 2;
    ASSERT_EQ(result.mask[middle], 1.0f);
    EXPECT_NEAR(result.deviation.data[middle], std::sqrt(0.16 / 3.0) / 1.012, 1e-5);
    EXPECT_NEAR(result.change.data[middle], 0.4 / 1.012, 1e-5);
}

TEST(Flicker, CountsPixelsThatHalfOfTheFramesShow) {
    // Each frame shifts by 4 of 32 pixels: the middle one (of 9) sees its left edge in the 5 frames up to it only.
    const Flicker result = flicker(path(9, 4.0f, [](std::size_t, vec3) { return 1.0f; }));
    EXPECT_EQ(result.mask[height / 2 * width], 1.0f);
    // Without those before it there are 4 frames of 9 that see the point.
    auto frames = path(9, 4.0f, [](std::size_t, vec3) { return 1.0f; });
    frames.front().depth = Image(width, height, 1);
    EXPECT_EQ(flicker(frames).mask[height / 2 * width], 0.0f);
}

TEST(Flicker, ErrorsThatAreKnownCanBeTakenOut) {
    // A light of 1 whose error is +a and -a by frame; samples of the error are as large.
    constexpr float a = 0.1f;
    auto frames = path(4, 0.0f, [](std::size_t frame, vec3) { return frame % 2 == 0 ? 1.0f + a : 1.0f - a; });
    for (std::size_t i = 0; i < frames.size(); ++i) light(frames[i], &PathFrame::error, [&](vec3) { return i < 2 ? a : -a; });
    const Flicker result = flicker(frames);
    EXPECT_NEAR(result.deviation_of_error, a / (1.0 + 0.01 * 1.1), 1e-5);
    EXPECT_DOUBLE_EQ(less_error(5.0, 3.0), 4.0);
    EXPECT_EQ(less_error(3.0, 5.0), 0.0);
}

TEST(Flicker, CountsSurfacesWithoutAnyLight) {
    // The left quarter of the first of two frames; a quarter of its pixels is background, which does not count.
    auto frames = path(2, 0.0f, [](std::size_t, vec3) { return 1.0f; });
    for (std::uint32_t y = 0; y < height; ++y) {
        std::fill_n(frames[0].value.pixel(0, y), 3 * width / 4, 0.0f);
        std::fill_n(frames[0].depth.pixel(3 * width / 4, y), width / 4, 0.0f);
    }
    EXPECT_DOUBLE_EQ(flicker(frames).unlit, 0.25 / 1.75);
}

TEST(Flicker, RefusesWhatIsNoNumber) {
    auto frames = path(2, 0.0f, [](std::size_t, vec3) { return 1.0f; });
    frames[1].value.data[7] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(flicker(frames), Error);
}

TEST(FlickerFigures, ByHand) {
    Image map(5, 1, 1);
    map.data = {1, 2, 3, 4, 100};
    const FlickerFigures figures = flicker_figures(map, {1, 1, 1, 1, 0});
    EXPECT_DOUBLE_EQ(figures.rms, std::sqrt(30.0 / 4.0));
    EXPECT_EQ(figures.median, 2.0);
    EXPECT_EQ(figures.p99, 4.0);
    EXPECT_EQ(figures.pixels, 4u);
    EXPECT_EQ(flicker_figures(map, std::vector<float>(5)).pixels, 0u);
}

}  // namespace
}  // namespace sl
