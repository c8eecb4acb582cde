// SPDX-License-Identifier: MIT
// lib/rsm_disc.glsl: whatever the number of samples and the radius, the disc's mean is the plain sum over all texels.
#include <array>
#include <cmath>

#include "engine/core/math.h"
#include "shared/lights.h"
#include "shared/octahedral.h"
#include "shared/rsm.h"
#include "shared/view.h"
#include "tests/shader/library_fixture.h"

namespace sl {
namespace {

constexpr std::uint32_t size = 64;         // texels of a map's side
constexpr std::uint32_t pixel_side = 64;   // pixels of the square picture, each of which turns its disc differently
constexpr float map_side = 4.0f, texel_area = map_side * map_side / (size * size);

struct Disc {
    std::uint32_t samples = 64;  ///< of all layers together
    float radius = 0.3f;
    float strength = 1.0f;
    std::uint32_t asked = ~0u;   ///< samples asked for at the point; those of the disc when not given
};

struct Mean {
    double value = 0.0, standard_error = 0.0;
};

/// Suns that shine straight down on the plane y = 0, of which a round spot in the middle of their map reflects.
class RsmDiscLibrary : public LibraryTest {
  protected:
    void add_light(float radiosity, bool has_map = true, float spot_radius = 0.5f) {
        LightParams light{};
        light.kind = uvec4(light_directional, no_layer, has_map ? layers_ : no_layer, 0);
        light.direction = vec4(0, -1, 0, 0);
        light.intensity = vec4(radiosity, radiosity, radiosity, map_side * map_side);
        light.map_clip_from_world = reversed_orthographic(0.5f * map_side, 0.5f * map_side, 0, 10) * view_from_world(vec3(0, 5, 0), vec3(0, -1, 0), vec3(0, 0, -1));
        lights_.push_back(light);
        if (!has_map) return;
        ++layers_;
        const vec2 up = glm::round((octahedral_encode(vec3(0, 1, 0)) * 0.5f + 0.5f) * 4094.0f);  // pack_texel_normal
        for (std::uint32_t i = 0; i < size * size; ++i) {
            const vec2 at = ((vec2(static_cast<float>(i % size), static_cast<float>(i / size)) + 0.5f) / static_cast<float>(size) - 0.5f) * map_side;
            const float lit = glm::length(at) < spot_radius ? radiosity : 0.0f;
            RsmPackedTexel texel;
            texel.position = vec4(at.x, 0, -at.y, up.x * 4096.0f + up.y);
            texel.light = vec4(vec3(lit * texel_area), texel_area);
            texels_.push_back(texel);
        }
    }

    void give_inputs(const Disc& disc) {
        // The lights are alike: each has the same share of the flux.
        for (LightParams& light : lights_) light.cone.z = light.kind.z != no_layer ? 1.0f / static_cast<float>(layers_) : 0.0f;
        RsmGatherParams params{};
        params.map = vec4(size, layers_, disc.strength, 1);
        params.disc = vec4(disc.samples, disc.radius, 1, 1);
        FrameParams frame{};
        frame.counts = uvec4(lights_.size(), 0, lights_.size(), lights_.size());
        float all = 0.0f;
        for (const LightParams& light : lights_) all += light.kind.z != no_layer ? light.intensity.x : 0.0f;
        for (LightParams& light : lights_) light.cone.z = light.kind.z != no_layer ? light.intensity.x / all : 0.0f;  // its share of the samples
        give("Gather", params);
        give("Frame", frame);
        give("Lights", lights_);
        give("Texels", texels_);
    }

    /// The irradiance that each pixel gathers at the same point.
    std::vector<vec4> gather(const Disc& disc, vec3 position, vec3 normal) {
        give_inputs(disc);
        return compute("#include \"lib/gbuffer.glsl\"\n#include \"lib/rsm_disc.glsl\"\n",
                       fmt::format("    Point point;\n    point.position = vec3({}, {}, {});\n    point.normal = vec3({}, {}, {});\n    point.distance = 1.0;\n"
                                   "    result.rgb = gather_disc(point, ivec2(i % {}u, i / {}u), {}u);",
                                   position.x, position.y, position.z, normal.x, normal.y, normal.z, pixel_side, pixel_side, disc.asked == ~0u ? disc.samples : disc.asked),
                       pixel_side * pixel_side);
    }
    Mean mean(const Disc& disc, vec3 position, vec3 normal) {
        const auto values = gather(disc, position, normal);
        Mean mean;
        double squares = 0.0;
        for (const vec4& value : values) {
            mean.value += value.x;
            squares += static_cast<double>(value.x) * value.x;
        }
        const double n = static_cast<double>(values.size());
        mean.value /= n;
        mean.standard_error = std::sqrt(std::max(squares / n - mean.value * mean.value, 0.0) / n);
        return mean;
    }

    /// The same light, each texel counted once.
    double plain_sum(vec3 position, vec3 normal) const {
        double sum = 0.0;
        for (const RsmPackedTexel& texel : texels_) {
            sum += texel_irradiance(vec3(texel.light), vec3(texel.position), vec3(0, 1, 0), texel_area, position, normal).x;
        }
        return sum;
    }

    std::vector<LightParams> lights_;
    std::vector<RsmPackedTexel> texels_;
    std::uint32_t layers_ = 0;
};

const vec3 above(0.1f, 0.8f, -0.05f), down(0, -1, 0);

/// What the mean may be off by. Samples lie on rings radius/N apart, and the light's edge, an eighth of the map from its
/// middle or further, falls between two: half a step too far out or in, it changes the area by radius / (N / 8). Above that,
/// four standard errors of the mean over the pixels.
double allowed(const Disc& disc, const Mean& mean, double truth) {
    return truth * disc.radius / (0.125 * disc.samples) + 4.0 * mean.standard_error;
}

TEST_F(RsmDiscLibrary, BrightnessDependsNeitherOnSamplesNorOnRadius) {
    add_light(1000.0f);
    const double truth = plain_sum(above, down);
    for (const std::uint32_t samples : {32u, 200u, 1000u}) {
        for (const float radius : {0.2f, 0.35f, 0.7f}) {  // 0.2 of the map's side just reaches the whole spot
            const Disc disc{.samples = samples, .radius = radius};
            const Mean found = mean(disc, above, down);
            EXPECT_NEAR(found.value, truth, allowed(disc, found, truth)) << samples << " samples in " << radius;
        }
    }
}

TEST_F(RsmDiscLibrary, LightsAddUp) {
    add_light(1000.0f);
    add_light(500.0f, false);  // has no map and gives nothing
    add_light(30.0f);
    const double truth = plain_sum(above, down);
    const Mean found = mean({.samples = 500}, above, down);
    // 427 samples for 97 % of the light and 73 for the rest: together as exact as 375 for all.
    EXPECT_NEAR(found.value, truth, allowed({.samples = 375}, found, truth));
}

TEST_F(RsmDiscLibrary, ReceiverBehindTheLightGathersRoundTheMapsMiddle) {
    add_light(1000.0f);
    lights_[0].map_clip_from_world = reversed_infinite_perspective(1.0f, 1.0f, 0.1f) * view_from_world(vec3(0), vec3(0, -1, 0), vec3(0, 0, -1));
    // To the side, where a projection through the light itself would put the disc beside the spot.
    const vec3 beside(1.0f, 0.8f, 0.0f);
    const Disc disc{.samples = 500};
    const Mean found = mean(disc, beside, down);
    const double truth = plain_sum(beside, down);
    EXPECT_NEAR(found.value, truth, allowed(disc, found, truth));
}

TEST_F(RsmDiscLibrary, SamplesOutsideTheMapHoldNothing) {
    add_light(1000.0f, true, map_side);  // lit up to its border and corners
    const double truth = plain_sum(above, down);
    const Disc disc{.samples = 1000, .radius = 1.0f};
    const Mean found = mean(disc, above, down);
    EXPECT_NEAR(found.value, truth, allowed(disc, found, truth));
}

TEST_F(RsmDiscLibrary, StrengthScalesEachPixel) {
    add_light(1000.0f);
    const auto once = gather({}, above, down), twice = gather({.strength = 2.0f}, above, down);
    for (std::size_t i = 0; i < once.size(); ++i) expect_close(twice[i], 2.0f * once[i], 1e-6f, i);
}

TEST_F(RsmDiscLibrary, NothingComesWithoutSamplesNorFromBehind) {
    add_light(1000.0f);
    for (const vec4& value : gather({.asked = 0}, above, down)) ASSERT_EQ(vec3(value), vec3(0)) << "no samples";
    for (const vec4& value : gather({}, above, vec3(0, 1, 0))) ASSERT_EQ(vec3(value), vec3(0)) << "faces away";
    for (const vec4& value : gather({}, vec3(0.1f, -0.8f, 0), vec3(0, 1, 0))) ASSERT_EQ(vec3(value), vec3(0)) << "under the plane";
}

TEST_F(RsmDiscLibrary, PixelsTurnTheirDiscsEvenly) {
    give_inputs({});
    std::array<int, 16> bins{};
    const std::string body = fmt::format("    result.x = pixel_turn(ivec2(i % {0}u, i / {0}u));", pixel_side);
    for (const vec4& turn : compute("#include \"lib/gbuffer.glsl\"\n#include \"lib/rsm_disc.glsl\"\n", body, pixel_side * pixel_side)) {
        ASSERT_TRUE(turn.x >= 0.0f && turn.x < 1.0f);
        ++bins[static_cast<std::size_t>(turn.x * 16.0f)];
    }
    for (const int bin : bins) EXPECT_NEAR(bin, 256, 78) << "five standard deviations of a fair draw";
}

}  // namespace
}  // namespace sl
