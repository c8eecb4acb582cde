// SPDX-License-Identifier: MIT
#include "engine/render/gl/texture.h"

#include <cmath>
#include <numeric>

#include "tests/render/gl/gl_fixture.h"

namespace sl::gl {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::FloatEq;
using testing::FloatNear;
using testing::Pointwise;

class TextureTest : public GlTest {};
SL_ON_BOTH_CONTEXTS(TextureTest);

template <class T>
std::vector<float> round_trip(const TextureDesc& desc, const std::vector<T>& values,
                              std::uint32_t layer = 0) {
    Texture texture(desc, "round trip");
    texture.upload(0, layer, std::as_bytes(std::span(values)));
    return texture.read(layer);
}

TextureDesc small(Format format) {
    return {.width = 2, .height = 1, .format = format};
}

TEST_P(TextureTest, KeepsBytes) {
    const std::vector<std::uint8_t> four = {0, 51, 102, 255, 1, 2, 3, 4};
    std::vector<float> expected;
    for (std::uint8_t byte : four) expected.push_back(static_cast<float>(byte) / 255.0f);
    EXPECT_THAT(round_trip(small(Format::rgba8), four), Pointwise(FloatNear(1e-6f), expected));
    const std::vector<std::uint8_t> two = {0, 255, 51, 102};
    EXPECT_THAT(round_trip(small(Format::rg8), two), Pointwise(FloatNear(1e-6f), {0.0f, 1.0f, 0.2f, 0.4f}));
}

TEST_P(TextureTest, DecodesSrgbColoursButNotAlpha) {
    const std::vector<std::uint8_t> values = {0, 188, 255, 188, 10, 64, 128, 0};
    const auto read = round_trip(small(Format::srgb8_alpha8), values);
    EXPECT_THAT(read, Pointwise(FloatNear(1e-4f), {0.0f, 0.50289f, 1.0f, 188.0f / 255.0f,  //
                                                   0.0030353f, 0.051269f, 0.215861f, 0.0f}));
}

TEST_P(TextureTest, KeepsShorts) {
    const std::vector<std::uint16_t> values = {0, 65535, 13107, 1};
    EXPECT_THAT(round_trip(small(Format::rg16), values),
                Pointwise(FloatNear(1e-7f), {0.0f, 1.0f, 0.2f, 1.0f / 65535.0f}));
}

TEST_P(TextureTest, KeepsHalves) {
    const std::vector<std::uint16_t> one = {0x3c00, 0xc100};  // 1, -2.5
    EXPECT_THAT(round_trip(small(Format::r16f), one), ElementsAre(1.0f, -2.5f));
    const std::vector<std::uint16_t> four = {0x3c00, 0xc100, 0x7bff, 0x0001, 0, 0, 0, 0x3800};
    EXPECT_THAT(round_trip(small(Format::rgba16f), four),
                ElementsAre(1.0f, -2.5f, 65504.0f, std::ldexp(1.0f, -24), 0.0f, 0.0f, 0.0f, 0.5f));
}

TEST_P(TextureTest, KeepsFloatsExactly) {
    for (Format format : {Format::r32f, Format::rg32f, Format::rgba32f}) {
        std::vector<float> values(2 * channel_count(format));
        std::iota(values.begin(), values.end(), -1.1f);
        values.front() = 3e38f;
        EXPECT_EQ(round_trip(small(format), values), values);
    }
    const std::vector<float> depth = {1e-6f, 0.75f};
    EXPECT_EQ(round_trip(small(Format::depth32f), depth), depth);
}

TEST_P(TextureTest, KeepsIntegers) {
    const std::vector<std::uint32_t> one = {7, 0x80000000u};
    EXPECT_THAT(round_trip(small(Format::r32ui), one), ElementsAre(7.0f, 2147483648.0f));
    const std::vector<std::uint32_t> two = {1, 2, 3, 16777216};
    EXPECT_THAT(round_trip(small(Format::rg32ui), two), ElementsAre(1.0f, 2.0f, 3.0f, 16777216.0f));
}

TEST_P(TextureTest, OddWidthsArePackedTightly) {
    std::vector<std::uint8_t> values(3 * 5 * 2);
    std::iota(values.begin(), values.end(), std::uint8_t{0});
    const auto read = round_trip({.width = 3, .height = 5, .format = Format::rg8}, values);
    ASSERT_EQ(read.size(), values.size());
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(read[i] * 255.0f, values[i], 1e-3f);
}

TEST_P(TextureTest, LayersAndMipsAreApart) {
    Texture texture({.width = 2, .height = 2, .layers = 3, .mips = 2, .format = Format::r32f}, "array");
    for (std::uint32_t layer = 0; layer < 3; ++layer) {
        const std::vector<float> values(4, static_cast<float>(layer));
        texture.upload(0, layer, std::as_bytes(std::span(values)));
    }
    const std::vector<float> mip = {9.0f};
    texture.upload(1, 1, std::as_bytes(std::span(mip)));
    for (std::uint32_t layer = 0; layer < 3; ++layer) {
        EXPECT_THAT(texture.read(layer), Each(FloatEq(static_cast<float>(layer))));
    }
    float read = 0.0f;
    glGetTextureSubImage(texture.id(), 1, 0, 0, 1, 1, 1, 1, GL_RED, GL_FLOAT, sizeof(read), &read);
    EXPECT_EQ(read, 9.0f);
}

TEST_P(TextureTest, MoveLeavesOneOwner) {
    Texture first(small(Format::rgba8), "first");
    const GLuint id = first.id();
    Texture second = std::move(first);
    EXPECT_EQ(second.id(), id);
    EXPECT_EQ(second.desc(), small(Format::rgba8));
    second = Texture(small(Format::r32f));
    EXPECT_EQ(second.desc().format, Format::r32f);
    EXPECT_FALSE(Texture());
}

TEST_P(TextureTest, CarriesItsLabel) {
    Texture texture(small(Format::rgba8), "rsm_flux");
    char label[64] = {};
    glGetObjectLabel(GL_TEXTURE, texture.id(), sizeof(label), nullptr, label);
    EXPECT_STREQ(label, "rsm_flux");
    Texture long_name(small(Format::rgba8), std::string(5000, 'x').c_str());
}

TEST_P(TextureTest, MistakesStop) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_DEATH(Texture({.width = 0}), "0 x 1");
    EXPECT_DEATH(Texture({.width = 4, .height = 4, .mips = 4}), "4 mips");
    EXPECT_DEATH(Texture({.width = 4}).upload(0, 0, {}), "0 bytes for a mip of 16");
    EXPECT_DEATH(Texture({.width = 4}).read(1), "no layer 1");
}

}  // namespace
}  // namespace sl::gl
