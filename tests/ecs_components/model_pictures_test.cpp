// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/model_pictures.h"

#include <gmock/gmock.h>

namespace sl {
namespace {

using namespace std::string_literals;
using testing::HasSubstr;

/// A PNG that says that it is 16384 x 4096, as large as one may be, and ends with its first pixels.
const std::string large = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x40\0\0\0\x10\0\x08\x06\0\0\0\x8a\x1d\xf9\x33\0\0\0\x0dIDATx\x9c\x63\x60\x50\xf5\xca\x07\0\x01\x77\0\xdf\x9c\xdb\xa7\x17\0\0\0\0IEND\xae\x42\x60\x82"s;

/// A material for each image.
Model model_of(std::size_t images) {
    Model model;
    for (std::size_t i = 0; i < images; ++i) {
        ModelImage& image = model.images.emplace_back();
        image.name = fmt::format("picture {}", i);
        for (const char byte : large) image.bytes.push_back(static_cast<std::byte>(byte));
        model.materials.emplace_back().base_colour_texture.image = static_cast<std::int32_t>(i);
    }
    return model;
}

TEST(ModelPictures, MorePixelsThanTheirBytesAccountForAreNotDecoded) {
    ModelProgress progress;
    const ModelPictures pictures = model_pictures(model_of(3), progress, 1 << 20);
    ASSERT_EQ(pictures.colours.layers.size(), 3u);
    ASSERT_EQ(pictures.warnings.size(), 3u);
    for (const std::size_t i : {0u, 1u}) EXPECT_THAT(pictures.warnings[i], HasSubstr(fmt::format("picture {}: it cannot be decoded", i)));
    EXPECT_EQ(pictures.warnings[2], "picture 2: it is 16384 x 4096, and the pictures before it leave 0 of 128 million pixels; it is white");
}

TEST(ModelPictures, ImagesOfTheSameBytesAreOneLayer) {
    Model model = model_of(2);
    model.images[1] = {.name = "the same", .bytes = {}, .same_as = 0};
    ModelProgress progress;
    const ModelPictures pictures = model_pictures(model, progress, 1 << 20);
    EXPECT_EQ(pictures.colours.layers.size(), 1u);
    for (const auto& params : pictures.materials) EXPECT_EQ(params->layers.x, 0u);
}

}  // namespace
}  // namespace sl
