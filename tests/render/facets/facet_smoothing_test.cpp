// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_smoothing.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/core/math.h"

namespace sl {
namespace {

constexpr std::uint32_t side = 24;

/// A square floor of facets.
class Floor : public testing::Test {
  protected:
    void SetUp() override {
        for (std::uint32_t y = 0; y + 1 < side; ++y) {
            for (std::uint32_t x = 0; x + 1 < side; ++x) {
                const std::uint32_t low = y * side + x;
                facets.push_back({.name = low + 1, .corners = {low, low + 1, low + side, low + side + 1}, .split = false});
            }
        }
    }
    double error(float truth) {
        double squares = 0.0;
        for (const vec3& value : light) squares += (value.y / truth - 1.0) * (value.y / truth - 1.0);
        return std::sqrt(squares / static_cast<double>(light.size()));
    }

    std::vector<FacetEntry> facets;
    std::vector<vec3> light = std::vector<vec3>(side * side, vec3(100.0f));
    std::vector<float> variance = std::vector<float>(side * side, 0.16f);
    FacetSmoothing smoothing;
};

TEST_F(Floor, EvenLightStaysAsItIs) {
    smoothing.smooth(facets, light, variance);
    for (const vec3& value : light) EXPECT_NEAR(value.y, 100.0f, 0.01f);
}

TEST_F(Floor, NoiseFallsToLessThanHalf) {
    std::mt19937 engine(3);
    std::gamma_distribution<float> noisy(6.25f, 16.0f);  // mean 100, relative variance 0.16
    for (vec3& value : light) value = vec3(noisy(engine));
    const double before = error(100.0f);
    smoothing.smooth(facets, light, variance);
    EXPECT_LT(error(100.0f), 0.5 * before);
    double mean = 0.0;
    for (const vec3& value : light) mean += value.y / static_cast<double>(light.size());
    EXPECT_NEAR(mean, 100.0, 5.0) << "light is moved, not made";
}

TEST_F(Floor, WhatIsSureDoesNotListen) {
    light[side * 5 + 5] = vec3(700.0f);
    variance[side * 5 + 5] = 0.0f;
    smoothing.smooth(facets, light, variance);
    EXPECT_EQ(light[side * 5 + 5], vec3(700.0f));
}

TEST_F(Floor, WhatSeemsDarkIsHelped) {
    light[side * 5 + 5] = vec3(0.0f);
    smoothing.smooth(facets, light, variance);
    EXPECT_GT(light[side * 5 + 5].y, 50.0f);
}

TEST_F(Floor, WhatHasNoLightYetNeitherSpeaksNorListens) {
    light[side * 5 + 5] = vec3(1e9f);
    variance[side * 5 + 5] = -1.0f;
    smoothing.smooth(facets, light, variance);
    EXPECT_EQ(light[side * 5 + 5], vec3(1e9f));
    EXPECT_NEAR(light[side * 5 + 6].y, 100.0f, 0.01f);
}

TEST_F(Floor, LittleNoiseIsLeftAsItIs) {
    std::ranges::fill(variance, 0.03f);
    light[7] = vec3(80.0f);
    const auto before = light;
    smoothing.smooth(facets, light, variance);
    EXPECT_EQ(light, before);
}

TEST_F(Floor, ExtremesStayNumbers) {
    light[0] = vec3(1e30f);
    light[1] = vec3(1e-30f);
    light[2] = vec3(0.0f);
    variance[3] = 1e30f;
    smoothing.smooth(facets, light, variance);
    for (const vec3& value : light) EXPECT_TRUE(std::isfinite(value.y));
}

}  // namespace
}  // namespace sl
