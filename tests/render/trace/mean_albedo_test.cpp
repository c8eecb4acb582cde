// SPDX-License-Identifier: MIT
#include "engine/render/trace/mean_albedo.h"

#include <gtest/gtest.h>

#include "engine/render/trace/directions.h"
#include "engine/render/trace/samples.h"

namespace sl {
namespace {

Surface surface_of(vec3 colour, float metallic, float roughness, float specular) {
    return {.base_colour = vec4(colour, roughness), .normal = vec4(0, 0, 1, metallic), .specular = vec4(specular, 0, 0, 0)};
}

/// The same by directions that know nothing of the lobe.
vec3 by_cosines(const Surface& surface) {
    constexpr std::uint32_t count = 1 << 18;
    dvec3 sum(0.0);
    for (std::uint32_t i = 0; i < count; ++i) {
        SampleSequence samples(1, uvec2(0), i);
        const vec3 to_light = cosine_direction(samples.pair()), to_eye = cosine_direction(samples.pair());
        if (to_light.z > 0.0f) sum += dvec3(reflected(surface, to_light, to_eye) * (pi / to_light.z));
    }
    return vec3(sum / double{count});
}

TEST(MeanAlbedo, IsTheMeanOfTheBrdf) {
    for (const float roughness : {0.35f, 0.6f, 0.83f, 1.0f}) {
        for (const float metallic : {0.0f, 0.4f, 1.0f}) {
            for (const float specular : {0.0f, 0.5f, 1.0f}) {
                const Surface surface = surface_of(vec3(0.8f, 0.5f, 0.1f), metallic, roughness, specular);
                const vec3 albedo = mean_albedo(surface), expected = by_cosines(surface);
                for (int i = 0; i < 3; ++i) EXPECT_NEAR(albedo[i], expected[i], 0.005f) << roughness << " " << metallic << " " << specular;
            }
        }
    }
}

TEST(MeanAlbedo, OfASmoothMetalIsNearlyItsColourAndOfARoughOneFarLess) {
    EXPECT_NEAR(mean_albedo(surface_of(vec3(0.9f), 1.0f, 0.0f, 1.0f)).x, 0.9f, 0.02f);
    const float rough = mean_albedo(surface_of(vec3(0.9f), 1.0f, 1.0f, 1.0f)).x;
    EXPECT_LT(rough, 0.65f);
    EXPECT_GT(rough, 0.3f);
}

TEST(MeanAlbedo, OfAMatteSurfaceIsItsColour) { EXPECT_EQ(mean_albedo(surface_of(vec3(0.7f, 0.2f, 0.0f), 0.0f, 1.0f, 0.0f)), vec3(0.7f, 0.2f, 0.0f)); }

}  // namespace
}  // namespace sl
