// SPDX-License-Identifier: MIT
// Rays to bright places: their density is what it says, or the light that they bring would be wrong.
#include <gtest/gtest.h>

#include "engine/render/facets/guide.h"
#include "engine/render/trace/samples.h"

namespace sl {
namespace {

Guide three_balls() {
    Guide guide;
    guide.add(vec3(0, 3, 0), 0.5f, 4.0f);
    guide.add(vec3(5, 1, 0), 0.1f, 1.0f);
    guide.add(vec3(0.2f, 0, 0), 1.0f, 2.0f);  // the origin is inside
    guide.finish(8);
    return guide;
}

vec3 direction_of(vec2 xi) {
    const float z = 1.0f - 2.0f * xi.x, radius = std::sqrt(std::max(1.0f - z * z, 0.0f));
    return vec3(radius * std::cos(2.0f * pi * xi.y), radius * std::sin(2.0f * pi * xi.y), z);
}

TEST(Guide, DensityIsThatOfItsSamples) {
    const Guide guide = three_balls();
    // The part of samples in a cap against the density's integral over it, for caps of many sizes around one target.
    for (const float cosine : {0.999f, 0.99f, 0.9f, 0.0f, -1.0f}) {
        const vec3 axis(0, 1, 0);
        double drawn = 0.0, integral = 0.0;
        constexpr std::uint32_t count = 1u << 17;
        for (std::uint32_t i = 0; i < count; ++i) {
            SampleSequence samples(1, uvec2(0), i);
            const vec2 xi = samples.pair();
            if (glm::dot(guide.sample(vec3(0), xi, samples.pair().x), axis) >= cosine) drawn += 1.0 / count;
            const vec3 anywhere = direction_of(samples.pair());
            if (glm::dot(anywhere, axis) >= cosine) integral += 4.0 * M_PI * guide.density(vec3(0), anywhere) / count;
        }
        EXPECT_NEAR(drawn, integral, 0.02) << "cap of cosine " << cosine;
    }
}

TEST(Guide, SamplesHaveADensity) {
    const Guide guide = three_balls();
    for (std::uint32_t i = 0; i < 1000; ++i) {
        SampleSequence samples(2, uvec2(0), i);
        const vec2 xi = samples.pair();
        const vec3 direction = guide.sample(vec3(1, 0, -2), xi, samples.pair().x);
        EXPECT_NEAR(glm::length(direction), 1.0f, 1e-5f);
        EXPECT_GT(guide.density(vec3(1, 0, -2), 0.999999f * direction), 0.0f);
    }
}

TEST(Guide, BallsThatLieTogetherBecomeOne) {
    Guide guide;
    guide.add(vec3(0), 1.0f, 1.0f);
    guide.add(vec3(0.5f, 0, 0), 1.0f, 1.0f);
    guide.add(vec3(9, 0, 0), 1.0f, 2.0f);
    guide.finish(8);
    ASSERT_EQ(guide.targets.size(), 2u);
    for (const Guide::Target& target : guide.targets) EXPECT_NEAR(target.share, 0.5f, 1e-6f);
    Guide one;
    for (int i = 0; i < 5; ++i) one.add(vec3(10.0f * static_cast<float>(i), 0, 0), 1.0f, 1.0f + static_cast<float>(i));
    one.finish(2);
    ASSERT_EQ(one.targets.size(), 2u) << "the brightest are kept";
    EXPECT_NEAR(one.targets[0].share, 5.0f / 9.0f, 1e-6f);
}

}  // namespace
}  // namespace sl
