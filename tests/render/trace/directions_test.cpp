// SPDX-License-Identifier: MIT
#include "engine/render/trace/directions.h"

#include <gtest/gtest.h>

#include "engine/render/trace/samples.h"

namespace sl {
namespace {

Surface metal(float roughness) {
    Surface surface{};
    surface.base_colour = vec4(1, 1, 1, roughness);
    surface.normal = vec4(glm::normalize(vec3(0.3f, -0.5f, 0.8f)), 1.0f);
    surface.specular = vec4(1.0f);
    return surface;
}

/// A unit vector at an angle to the surface's normal.
vec3 eye_at(const Surface& surface, float angle) {
    const mat3 basis = basis_around(vec3(surface.normal));
    return basis * vec3(std::sin(angle) * 0.6f, std::sin(angle) * 0.8f, std::cos(angle));
}

TEST(Directions, BasisIsOrthonormal) {
    for (const vec3 axis : {vec3(0, 0, 1), vec3(0, 0, -1), vec3(1, 0, 0), glm::normalize(vec3(1, -2, -3))}) {
        const mat3 b = basis_around(axis);
        const mat3 identity = glm::transpose(b) * b;
        for (int i = 0; i < 3; ++i) {
            for (int j = 0; j < 3; ++j) EXPECT_NEAR(identity[i][j], i == j ? 1.0f : 0.0f, 1e-6f);
        }
        EXPECT_EQ(b[2], axis);
    }
}

TEST(Directions, DensityIsThatOfTheSamples) {
    // Means of a function of the direction, once over the samples and once over the hemisphere with the density.
    const auto function = [](vec3 d) { return 1.0 + 0.5 * d.x - 0.3 * d.y + d.z * d.z; };
    for (const float roughness : {0.3f, 0.6f, 1.0f}) {
        for (const float angle : {0.1f, 0.8f, 1.4f}) {
            const Surface surface = metal(roughness);
            const DirectionSampler sampler(surface, eye_at(surface, angle), false, 0.25f);
            const mat3 basis = basis_around(vec3(surface.normal));
            double drawn = 0.0, integrated = 0.0;
            constexpr std::uint32_t count = 1 << 18;
            for (std::uint32_t i = 0; i < count; ++i) {
                SampleSequence samples(7, uvec2(0), i);
                const vec3 direction = sampler.sample(samples.pair());
                if (sampler.density(direction) > 0.0f) drawn += function(direction);
                const vec2 xi = samples.pair();
                const float sine = std::sqrt(1.0f - xi.x * xi.x);
                const vec3 uniform = basis * vec3(sine * std::cos(2.0f * pi * xi.y), sine * std::sin(2.0f * pi * xi.y), xi.x);
                integrated += function(uniform) * sampler.density(uniform) * 2.0f * pi;
            }
            EXPECT_NEAR(drawn / integrated, 1.0, 0.01) << "roughness " << roughness << ", angle " << angle;
        }
    }
}

TEST(Directions, ReflectanceDoesNotDependOnTheSampler) {
    const Surface surface = metal(1.0f);
    const vec3 eye = eye_at(surface, 0.3f);
    const DirectionSampler lobes(surface, eye, false, 0.0f), cosine(surface, eye, true, 0.0f);
    double by_lobes = 0.0, by_cosine = 0.0;
    constexpr std::uint32_t count = 1 << 16;
    for (std::uint32_t i = 0; i < count; ++i) {
        SampleSequence samples(3, uvec2(0), i);
        for (auto [sampler, sum] : {std::pair(&lobes, &by_lobes), std::pair(&cosine, &by_cosine)}) {
            const vec3 direction = sampler->sample(samples.pair());
            const float density = sampler->density(direction);
            if (density > 0.0f) *sum += reflected(surface, direction, eye).y / density;
        }
    }
    EXPECT_NEAR(by_lobes / count, by_cosine / count, 0.003);
}

}  // namespace
}  // namespace sl
