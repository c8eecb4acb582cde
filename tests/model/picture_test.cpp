// SPDX-License-Identifier: MIT
#include "engine/core/model/picture.h"

#include "engine/core/image.h"
#include "tests/model/model_fixture.h"

/// Under the sanitizers: OpenImageIO 2.4 loses the text of each error that it has told.
extern "C" const char* __lsan_default_suppressions() { return "leak:ImageInput::geterror\n"; }

namespace sl {
namespace {

class PictureTest : public ModelTest {
  protected:
    /// A PNG of such pixels, red to the left and green to the right.
    ModelImage red_and_green(std::uint32_t width, std::uint32_t height) {
        Image image(width, height, 3);
        for (std::uint32_t y = 0; y < height; ++y) {
            for (std::uint32_t x = 0; x < width; ++x) image.pixel(x, y)[2 * x < width ? 0 : 1] = 1.0f;
        }
        write_png(folder / "picture.png", image);
        std::ifstream stream(folder / "picture.png", std::ios::binary);
        const std::string bytes((std::istreambuf_iterator<char>(stream)), {});
        ModelImage result{.name = "picture.png", .bytes = {}};
        for (const char byte : bytes) result.bytes.push_back(static_cast<std::byte>(byte));
        return result;
    }
};

TEST_F(PictureTest, IsDecodedTopRowFirst) {
    const ModelImage image = red_and_green(4, 2);
    EXPECT_EQ(picture_size(image), uvec2(4, 2));
    const Picture picture = decode_picture(image);
    EXPECT_THAT(std::vector<std::uint8_t>(picture.pixels.begin(), picture.pixels.begin() + 4), testing::ElementsAre(255, 0, 0, 255));
    EXPECT_THAT(std::vector<std::uint8_t>(picture.pixels.begin() + 8, picture.pixels.begin() + 12), testing::ElementsAre(0, 255, 0, 255));
}

TEST_F(PictureTest, ALayerIsSquareAndItsMipsAverageLight) {
    const auto layer = picture_layer(decode_picture(red_and_green(8, 2)), 8, PictureKind::colour, true);
    EXPECT_EQ(picture_mips(8), 4u);
    ASSERT_EQ(layer.size(), 4u * (64 + 16 + 4 + 1));
    // Half the light of each, which sRGB encodes as 188.
    EXPECT_NEAR(layer[layer.size() - 4], 188, 2);
    EXPECT_NEAR(layer[layer.size() - 3], 188, 2);
    EXPECT_EQ(layer.back(), 255);
    const auto data = picture_layer(decode_picture(red_and_green(8, 2)), 8, PictureKind::data, true);
    EXPECT_NEAR(data[data.size() - 4], 128, 2);
}

TEST_F(PictureTest, WhatIsTruncatedOrNoneIsRefused) {
    ModelImage image = red_and_green(64, 64);
    image.bytes.resize(image.bytes.size() / 2);
    EXPECT_THROW((void)decode_picture(image), Error);
    image.bytes.resize(20);
    EXPECT_THROW((void)picture_size(image), Error);
    EXPECT_THROW((void)picture_size(ModelImage{.name = "empty", .bytes = {}}), Error);
}

TEST_F(PictureTest, AHeaderThatClaimsTooMuchIsRefusedBeforeAnythingIsDecoded) {
    ModelImage image = red_and_green(4, 2);
    // Width and height of the IHDR chunk, most significant byte first.
    for (const std::size_t at : {16u, 20u}) {
        image.bytes[at] = std::byte{0};
        image.bytes[at + 1] = std::byte{0};
        image.bytes[at + 2] = std::byte{0x7d};
    }
    EXPECT_THROW((void)picture_size(image), Error);
}

}  // namespace
}  // namespace sl
