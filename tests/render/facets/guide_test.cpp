// SPDX-License-Identifier: MIT
// Rays to bright places: their density is what it says, or the light that they bring would be wrong.
#include <gtest/gtest.h>

#include "engine/render/facets/guide.h"
#include "engine/render/trace/samples.h"

namespace sl {
namespace {

Guide three_balls() {
    Guide guide;
    guide.add(vec3(0, 3, 0), 0.5f, 4.0f, 4.0f);
    guide.add(vec3(5, 1, 0), 0.1f, 1.0f, 4.0f);
    guide.add(vec3(0.2f, 0, 0), 1.0f, 2.0f, 4.0f);  // the origin is inside
    guide.finish(8);
    return guide;
}

vec3 direction_of(vec2 xi) {
    const float z = 1.0f - 2.0f * xi.x, radius = std::sqrt(std::max(1.0f - z * z, 0.0f));
    return vec3(radius * std::cos(2.0f * pi * xi.y), radius * std::sin(2.0f * pi * xi.y), z);
}

TEST(Guide, DensityIsThatOfItsSamples) {
    const GuideCones guide(three_balls(), vec3(0));
    // The part of samples in a cap against the density's integral over it, for caps of many sizes around one target.
    for (const float cosine : {0.999f, 0.99f, 0.9f, 0.0f, -1.0f}) {
        const vec3 axis(0, 1, 0);
        double drawn = 0.0, integral = 0.0;
        constexpr std::uint32_t count = 1u << 17;
        for (std::uint32_t i = 0; i < count; ++i) {
            SampleSequence samples(1, uvec2(0), i);
            const vec2 xi = samples.pair();
            if (glm::dot(guide.sample(xi, samples.pair().x), axis) >= cosine) drawn += 1.0 / count;
            const vec3 anywhere = direction_of(samples.pair());
            if (glm::dot(anywhere, axis) >= cosine) integral += 4.0 * M_PI * guide.density(anywhere) / count;
        }
        EXPECT_NEAR(drawn, integral, 0.02) << "cap of cosine " << cosine;
    }
}

TEST(Guide, SamplesHaveADensity) {
    const GuideCones guide(three_balls(), vec3(1, 0, -2));
    for (std::uint32_t i = 0; i < 1000; ++i) {
        SampleSequence samples(2, uvec2(0), i);
        const vec2 xi = samples.pair();
        const vec3 direction = guide.sample(xi, samples.pair().x);
        EXPECT_NEAR(glm::length(direction), 1.0f, 1e-5f);
        EXPECT_GT(guide.density(0.999999f * direction), 0.0f);
    }
}

TEST(Guide, BallsThatLieTogetherBecomeOne) {
    Guide guide;
    guide.add(vec3(0), 1.0f, 1.0f, 4.0f);
    guide.add(vec3(0.5f, 0, 0), 1.0f, 1.0f, 4.0f);
    guide.add(vec3(9, 0, 0), 1.0f, 2.0f, 4.0f);
    guide.finish(8);
    ASSERT_EQ(guide.targets.size(), 2u);
    for (const Guide::Target& target : guide.targets) EXPECT_NEAR(target.share, 0.5f, 1e-6f);
    Guide one;
    for (int i = 0; i < 5; ++i) one.add(vec3(10.0f * static_cast<float>(i), 0, 0), 1.0f, 1.0f + static_cast<float>(i), 4.0f);
    one.finish(2);
    ASSERT_EQ(one.targets.size(), 2u) << "the brightest are kept";
    EXPECT_NEAR(one.targets[0].share, 5.0f / 9.0f, 1e-6f);
}

TEST(Guide, LearnsWhatIsHidden) {
    Guide guide;
    guide.add(vec3(0, 3, 0), 0.5f, 100.0f, 1.0f);  // bright, but something stands before it
    guide.add(vec3(3, 0, 0), 0.5f, 1.0f, 1.0f);
    guide.finish(8);
    const GuideCones cones(guide, vec3(0));
    std::vector<Guide::Yield> yields;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        SampleSequence samples(3, uvec2(0), i);
        const vec2 xi = samples.pair();
        const vec3 direction = cones.sample(xi, samples.pair().x);
        cones.account(yields, direction, direction.x > 0.5f ? 1.0f : 0.0f);
    }
    EXPECT_NEAR(yields[0].rays, 990.0f, 5.0f);
    ASSERT_TRUE(guide.learn(yields));
    ASSERT_EQ(guide.targets.size(), 1u);
    EXPECT_EQ(guide.targets[0].place, vec3(3, 0, 0));
    EXPECT_EQ(guide.targets[0].share, 1.0f);
    EXPECT_FALSE(guide.learn({{.rays = 100.0f, .squares = 7.0f}})) << "there is nothing to gain";
    EXPECT_FALSE(guide.learn({{.rays = 100.0f, .squares = 0.0f}})) << "no light has come yet";
}

}  // namespace
}  // namespace sl
