// SPDX-License-Identifier: MIT
#include "engine/measure/metrics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "engine/core/error.h"

namespace sl {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

/// A row of grey pixels.
Image greys(std::initializer_list<float> values, std::uint32_t channels = 3) {
    Image image(static_cast<std::uint32_t>(values.size()), 1, channels);
    std::size_t i = 0;
    for (const float value : values) {
        for (std::uint32_t c = 0; c < channels; ++c) image.data[i++] = value;
    }
    return image;
}

std::string refusal(const Image& image, const Image& reference, const std::vector<float>& mask) {
    try {
        image_errors(image, reference, mask);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(ImageErrors, ByHand) {
    // x = 3, 9 against r = 2, 6. Mean of r: 4. Differences 1, 3. ε = 0.04² = 0.0016.
    const ErrorMetrics errors = image_errors(greys({3, 9}), greys({2, 6}), {});
    EXPECT_DOUBLE_EQ(errors.nrmse, std::sqrt((1.0 + 9.0) / 2.0) / 4.0);
    EXPECT_DOUBLE_EQ(errors.bias, 2.0 / 4.0);
    EXPECT_DOUBLE_EQ(errors.rel_mse, 0.5 * (1.0 / 4.0016 + 9.0 / 36.0016));
    // Of two values, the ⌈1.9⌉ = 2nd smallest: the larger of 1 / 2.04 and 3 / 6.04.
    EXPECT_NEAR(errors.p95, 3.0 / 6.04, 1e-12);
    EXPECT_EQ(errors.pixels, 2u);
}

TEST(ImageErrors, EachChannelCountsAndLuminanceWeighs) {
    // One pixel: r = (1, 1, 1), x = (1, 1, 2). Mean of r 1; one of three values is off by 1.
    Image image = greys({1});
    image.data[2] = 2.0f;
    const ErrorMetrics errors = image_errors(image, greys({1}), {});
    EXPECT_DOUBLE_EQ(errors.nrmse, std::sqrt(1.0 / 3.0));
    EXPECT_DOUBLE_EQ(errors.bias, 1.0 / 3.0);
    EXPECT_DOUBLE_EQ(errors.rel_mse, 1.0 / 1.0001 / 3.0);
    // Blue's share of Rec. 709 luminance, over 1 + 1 %.
    EXPECT_NEAR(errors.p95, 0.0722 / 1.01, 1e-12);
}

TEST(ImageErrors, AlphaIsNoColour) {
    Image image = greys({1, 2}, 4);
    image.data[3] = 77.0f;
    EXPECT_EQ(image_errors(image, greys({1, 2}), {}).nrmse, 0.0);
}

TEST(ImageErrors, BiasCancelsWhereNrmseDoesNot) {
    const ErrorMetrics errors = image_errors(greys({1, 3}), greys({2, 2}), {});
    EXPECT_EQ(errors.bias, 0.0);
    EXPECT_DOUBLE_EQ(errors.nrmse, 0.5);
    EXPECT_LT(image_errors(greys({1, 1}), greys({2, 2}), {}).bias, 0.0);
}

TEST(ImageErrors, TheNinetyFifthPercentileLeavesFivePercentOut) {
    // 100 pixels of 1; 5 are off: the 95th smallest is still 0. With 6 off, it is not.
    Image reference(100, 1, 3), image(100, 1, 3);
    std::ranges::fill(reference.data, 1.0f);
    std::ranges::fill(image.data, 1.0f);
    std::fill_n(image.data.begin(), 5 * 3, 3.0f);
    EXPECT_EQ(image_errors(image, reference, {}).p95, 0.0);
    std::fill_n(image.data.begin(), 6 * 3, 3.0f);
    EXPECT_NEAR(image_errors(image, reference, {}).p95, 2.0 / 1.01, 1e-12);
}

TEST(ImageErrors, MaskedPixelsDoNotCount) {
    const ErrorMetrics errors = image_errors(greys({3, nan}), greys({2, infinity}), {1, 0});
    EXPECT_DOUBLE_EQ(errors.nrmse, 0.5);
    EXPECT_DOUBLE_EQ(errors.bias, 0.5);
    EXPECT_NEAR(errors.p95, 1.0 / 2.02, 1e-12);
    EXPECT_EQ(errors.pixels, 1u);
    // A masked pixel is not a zero among the percentile's values either.
    EXPECT_NEAR(image_errors(greys({3, 2}), greys({2, 2}), {1, 0}).p95, 1.0 / 2.02, 1e-12);
}

TEST(ImageErrors, EqualImagesHaveNone) {
    for (const Image& image : {greys({1, 2}), greys({0, 0}), greys({-1, 1})}) {
        const ErrorMetrics errors = image_errors(image, image, {});
        EXPECT_EQ(errors.rel_mse, 0.0);
        EXPECT_EQ(errors.nrmse, 0.0);
        EXPECT_EQ(errors.p95, 0.0);
        EXPECT_EQ(errors.bias, 0.0);
    }
}

TEST(ImageErrors, LightOnABlackReferenceIsAnInfiniteError) {
    const ErrorMetrics errors = image_errors(greys({1, 0}), greys({0, 0}), {});
    EXPECT_EQ(errors.rel_mse, infinity);
    EXPECT_EQ(errors.nrmse, infinity);
    EXPECT_EQ(errors.p95, infinity);
    EXPECT_EQ(errors.bias, infinity);
    EXPECT_EQ(image_errors(greys({-1, 0}), greys({0, 0}), {}).bias, -infinity);
}

TEST(ImageErrors, ADarkPixelInALitReferenceStaysFinite) {
    // r = 0, 2: mean 1, so the dark pixel's error of 0.1 counts as 0.1 / 0.01 = 10, squared 100; half of it is the
    // mean.
    const ErrorMetrics errors = image_errors(greys({0.1f, 2}), greys({0, 2}), {});
    EXPECT_NEAR(errors.p95, 10.0, 1e-5);
    EXPECT_NEAR(errors.rel_mse, 50.0, 1e-4);
}

TEST(ImageErrors, RatiosDoNotDependOnTheUnitOfLight) {
    const ErrorMetrics a = image_errors(greys({3, 9, 1}), greys({2, 6, 1.5f}), {});
    const ErrorMetrics b = image_errors(greys({3072, 9216, 1024}), greys({2048, 6144, 1536}), {});
    EXPECT_DOUBLE_EQ(a.rel_mse, b.rel_mse);
    EXPECT_DOUBLE_EQ(a.nrmse, b.nrmse);
    EXPECT_DOUBLE_EQ(a.p95, b.p95);
    EXPECT_DOUBLE_EQ(a.bias, b.bias);
}

TEST(ImageErrors, LargeValuesDoNotOverflow) {
    EXPECT_NEAR(image_errors(greys({2e38f, 2e38f}), greys({1e38f, 1e38f}), {}).nrmse, 1.0, 1e-6);
}

TEST(ImageErrors, NonFinitePixelsAreRefusedWithTheirPlace) {
    Image image(3, 2, 3);
    image.pixel(2, 0)[1] = nan;
    image.pixel(1, 1)[0] = infinity;
    image.pixel(1, 1)[1] = -infinity;
    const Image reference = Image(3, 2, 3);
    EXPECT_THAT(refusal(image, reference, {}), testing::HasSubstr("the image: 2 of 6 pixels"));
    EXPECT_THAT(refusal(image, reference, {}), testing::HasSubstr("column 2, row 0"));
    EXPECT_THAT(refusal(reference, image, {}), testing::StartsWith("the reference: 2 of 6"));
    EXPECT_THAT(refusal(image, reference, {1, 1, 0, 1, 1, 1}),
                testing::HasSubstr("1 of 6 pixels hold infinity or no number, the first at column 1, row 1"));
}

TEST(ImageErrors, NothingToCompareIsRefused) {
    EXPECT_THAT(refusal(greys({1, 2}), greys({1, 2}), {0, 0}), testing::HasSubstr("no pixel to compare"));
}

TEST(RelativeErrorMap, HoldsWhatThePercentileIsOf) {
    const Image map = relative_error_map(greys({3, 9, 5}), greys({2, 6, 1}), {1, 1, 0});
    ASSERT_EQ(map.channels, 1u);
    EXPECT_THAT(map.data, testing::Pointwise(testing::FloatNear(1e-6f), {1.0f / 2.04f, 3.0f / 6.04f, 0.0f}));
}

TEST(MaskedMean, CountsWhatTheMaskLeaves) {
    Image map(4, 1, 1);
    map.data = {1, 2, 3, 100};
    EXPECT_EQ(masked_mean(map, {}), 26.5);
    EXPECT_EQ(masked_mean(map, {1, 1, 1, 0}), 2.0);
    EXPECT_EQ(masked_mean(map, {0, 0, 0, 0}), 0.0);
}

}  // namespace
}  // namespace sl
