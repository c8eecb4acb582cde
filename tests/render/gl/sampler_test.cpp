// SPDX-License-Identifier: MIT
#include "engine/render/gl/texture.h"
#include "tests/render/gl/compute_fixture.h"

namespace sl::gl {
namespace {

using testing::FloatNear;
using testing::Pointwise;

class SamplerTest : public GlTest {
  protected:
    std::vector<float> sample(const Texture& texture, Sampling sampling, const std::string& declarations,
                              const std::string& body, std::size_t count) {
        const Samplers samplers;
        glBindTextureUnit(0, texture.id());
        glBindSampler(0, samplers.id(sampling));
        const auto values = compute(folder_, declarations, body, count);
        glBindTextureUnit(0, 0);
        glBindSampler(0, 0);
        return values;
    }
    static Texture two_pixels(Format format, float left, float right) {
        Texture texture({.width = 2, .height = 1, .format = format});
        const std::vector<float> values = {left, right};
        texture.upload(0, 0, std::as_bytes(std::span(values)));
        return texture;
    }

  private:
    TempFolder folder_;
};
SL_ON_BOTH_CONTEXTS(SamplerTest);

// Left, between the two pixels but nearer the left, past the right edge.
constexpr const char* three_places = R"(
    result[0] = textureLod(image, vec2(0.25, 0.5), 0.0).x;
    result[1] = textureLod(image, vec2(0.4375, 0.5), 0.0).x;
    result[2] = textureLod(image, vec2(1.75, 0.5), 0.0).x;)";

TEST_P(SamplerTest, NearestAndLinearClamp) {
    const Texture texture = two_pixels(Format::r32f, 0.0f, 8.0f);
    const std::string image = "uniform sampler2D image;";
    EXPECT_THAT(sample(texture, Sampling::nearest, image, three_places, 3),
                Pointwise(FloatNear(1e-4f), {0.0f, 0.0f, 8.0f}));
    EXPECT_THAT(sample(texture, Sampling::linear, image, three_places, 3),
                Pointwise(FloatNear(0.05f), {0.0f, 3.0f, 8.0f}));
}

TEST_P(SamplerTest, PixelArtRepeatsAndStaysSharp) {
    const Texture texture = two_pixels(Format::r32f, 0.0f, 8.0f);
    const std::string places = R"(
        result[0] = textureLod(image, vec2(0.4375, 0.5), 0.0).x;
        result[1] = textureLod(image, vec2(1.25, 0.5), 0.0).x;
        result[2] = textureLod(image, vec2(1.75, 0.5), 0.0).x;)";
    EXPECT_THAT(sample(texture, Sampling::pixel_art, "uniform sampler2D image;", places, 3),
                Pointwise(FloatNear(1e-4f), {0.0f, 0.0f, 8.0f}));
}

TEST_P(SamplerTest, PixelArtMixesMips) {
    Texture texture({.width = 2, .height = 1, .mips = 2, .format = Format::r32f});
    const std::vector<float> fine = {0.0f, 0.0f}, coarse = {4.0f};
    texture.upload(0, 0, std::as_bytes(std::span(fine)));
    texture.upload(1, 0, std::as_bytes(std::span(coarse)));
    EXPECT_THAT(sample(texture, Sampling::pixel_art, "uniform sampler2D image;",
                       "result[0] = textureLod(image, vec2(0.3, 0.5), 0.5).x;", 1),
                Pointwise(FloatNear(0.05f), {2.0f}));
}

// Reversed depth: a caster at 0.5 shadows what is farther, thus smaller.
constexpr const char* shadow_places = R"(
    result[0] = textureLod(map, vec3(0.25, 0.5, 0.6), 0.0);   // in front of the caster
    result[1] = textureLod(map, vec3(0.25, 0.5, 0.5), 0.0);   // the caster itself
    result[2] = textureLod(map, vec3(0.25, 0.5, 0.4), 0.0);   // behind it
    result[3] = textureLod(map, vec3(0.5, 0.5, 0.4), 0.0);    // half behind it, half behind nothing
    result[4] = textureLod(map, vec3(0.75, 0.5, 0.0), 0.0);   // infinitely far, behind nothing
    result[5] = textureLod(map, vec3(-0.5, 0.5, 0.4), 0.0);   // outside
    result[6] = textureLod(map, vec3(0.25, 9.0, 0.0), 0.0);   // outside, infinitely far)";

TEST_P(SamplerTest, ShadowCompareIsReversedAndLitOutside) {
    const Texture texture = two_pixels(Format::depth32f, 0.5f, 0.0f);
    EXPECT_THAT(sample(texture, Sampling::shadow_compare, "uniform sampler2DShadow map;", shadow_places, 7),
                Pointwise(FloatNear(0.01f), {1.0f, 1.0f, 0.0f, 0.5f, 1.0f, 1.0f, 1.0f}));
}

TEST_P(SamplerTest, ShadowCompareWorksOnLayers) {
    Texture texture({.width = 1, .height = 1, .layers = 2, .format = Format::depth32f});
    const std::vector<float> near = {0.9f}, far = {0.1f};
    texture.upload(0, 0, std::as_bytes(std::span(near)));
    texture.upload(0, 1, std::as_bytes(std::span(far)));
    EXPECT_THAT(sample(texture, Sampling::shadow_compare, "uniform sampler2DArrayShadow map;", R"(
                       result[0] = texture(map, vec4(0.5, 0.5, 0.0, 0.5));
                       result[1] = texture(map, vec4(0.5, 0.5, 1.0, 0.5));
                       result[2] = texture(map, vec4(0.5, 7.0, 0.0, 0.0));)",
                       3),
                Pointwise(FloatNear(0.01f), {0.0f, 1.0f, 1.0f}));
}

TEST_P(SamplerTest, SrgbIsDecodedAsReadDoes) {
    Texture texture({.width = 2, .height = 1, .format = Format::srgb8_alpha8});
    const std::vector<std::uint8_t> bytes = {188, 0, 0, 255, 64, 0, 0, 255};
    texture.upload(0, 0, std::as_bytes(std::span(bytes)));
    const auto read = texture.read();
    EXPECT_THAT(sample(texture, Sampling::nearest, "uniform sampler2D image;", three_places, 1),
                Pointwise(FloatNear(2e-3f), {read[0]}));
}

}  // namespace
}  // namespace sl::gl
