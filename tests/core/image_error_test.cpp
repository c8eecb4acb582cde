// SPDX-License-Identifier: MIT
#include "engine/core/image_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sl {
namespace {

Image two_pixels(float first, float second) {
    Image image(2, 1, 3);
    for (std::size_t c = 0; c < 3; ++c) {
        image.data[c] = first;
        image.data[3 + c] = second;
    }
    return image;
}

TEST(ImageError, ByHand) {
    // Differences 1 and 3 against a mean of 4: √((1 + 9) / 2) / 4.
    EXPECT_DOUBLE_EQ(nrmse(two_pixels(3, 9), two_pixels(2, 6), {}), std::sqrt(5.0) / 4.0);
}

TEST(ImageError, MaskedPixelsDoNotCount) {
    EXPECT_DOUBLE_EQ(nrmse(two_pixels(3, 9), two_pixels(2, 6), {1, 0}), 0.5);
}

TEST(ImageError, EqualAndBlack) {
    EXPECT_EQ(nrmse(two_pixels(1, 2), two_pixels(1, 2), {}), 0.0);
    EXPECT_EQ(nrmse(two_pixels(0, 0), two_pixels(0, 0), {}), 0.0);
    EXPECT_TRUE(std::isinf(nrmse(two_pixels(1, 0), two_pixels(0, 0), {})));
}

}  // namespace
}  // namespace sl
