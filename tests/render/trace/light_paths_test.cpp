// SPDX-License-Identifier: MIT
// Looking for lit points from the lights' side changes the noise and nothing else.
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "engine/render/trace/light_paths.h"
#include "engine/render/reference/reference.h"
#include "engine/render/trace/samples.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

using Light = RenderScene::Light;

TEST(SquareDensity, IntegratesToOneAndIsWhatItSamples) {
    std::vector<WeightedPoint> points;
    for (std::uint32_t i = 0; i < 400; ++i) {
        const vec2 xi = SampleSequence(3, {1, 2}, i).pair();
        points.push_back({vec2(0.7f, 0.2f) + 0.03f * xi, 1.0f + xi.x});
    }
    const SquareDensity density(points);
    constexpr int side = 512, cells = 16;
    std::vector<double> mass(cells * cells), drawn(cells * cells);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            mass[y * cells / side * cells + x * cells / side] += density.density((vec2(x, y) + 0.5f) / float(side)) / (side * side);
        }
    }
    constexpr std::uint32_t samples = 1 << 16;
    for (std::uint32_t i = 0; i < samples; ++i) {
        const vec2 at = density.sample(SampleSequence(1, {0, 0}, i).pair());
        ASSERT_GT(density.density(at), 0.0f);
        drawn[int(at.y * cells) * cells + int(at.x * cells)] += 1.0 / samples;
    }
    double total = 0.0;
    for (int i = 0; i < cells * cells; ++i) {
        total += mass[i];
        EXPECT_NEAR(drawn[i], mass[i], 2e-3) << "cell " << i % cells << ", " << i / cells;
    }
    EXPECT_NEAR(total, 1.0, 1e-4);
    EXPECT_GT(density.density({0.715f, 0.215f}), 100.0f);  // the points lie in a thousandth of the square
    EXPECT_EQ(density.density({1.0f, 0.5f}), 0.0f);
    EXPECT_EQ(density.density({-0.1f, 0.5f}), 0.0f);
}

TEST(SquareDensity, UniformWithoutPoints) {
    const SquareDensity density({});
    EXPECT_FLOAT_EQ(density.density({0.3f, 0.9f}), 1.0f);
    for (const vec2 xi : {vec2(0.25f, 0.75f), vec2(0.0f), vec2(0.99999994f)}) EXPECT_GT(density.density(density.sample(xi)), 0.0f);
}

TEST(LightPaths, DensityIsThatOfTheRaysInAllDirections) {
    // The mean of 1 / density is the whole of what can be met, here the sphere of directions, once.
    std::vector<LitPoint> found;
    for (std::uint32_t i = 0; i < 5000; ++i) {
        const vec2 xi = SampleSequence(7, {0, 0}, i).pair();
        const float z = 1.0f - 2.0f * xi.x, radius = std::sqrt(1.0f - z * z), angle = 2.0f * pi * xi.y;
        found.push_back({0, vec3(radius * std::cos(angle), radius * std::sin(angle), z), 1.0f});
    }
    LightParams lamp{};
    lamp.kind.x = light_point;
    const LightPaths paths(std::span(&lamp, 1), {}, found);
    double sum = 0.0;
    constexpr std::uint32_t samples = 1 << 18;
    for (std::uint32_t i = 0; i < samples; ++i) {
        const Ray ray = paths.sample(SampleSequence(1, {0, 0}, i).pair()).ray;
        SurfacePoint point;
        point.position = ray.direction;
        point.face = -ray.direction;
        const float density = paths.density(0, point);
        ASSERT_GT(density, 0.0f);
        sum += 1.0 / double{density};
    }
    EXPECT_NEAR(sum / samples, 4.0 * M_PI, 1e-3);
}

/// A room whose only light is that of one lamp of the kind, shining on its floor through a small hole in a lid.
RenderScene& room(SceneBuilder& builder, Light::Kind kind) {
    const auto at = [](vec3 place) { return glm::translate(mat4(1.0f), place); };
    builder.add({Shape::Kind::box, vec3(6, 0.2f, 6)}, at(vec3(0, -0.1f, 0)), vec3(0.8f, 0.3f, 0.3f));
    for (const float side : {-1.0f, 1.0f}) {
        builder.add({Shape::Kind::box, vec3(0.2f, 3, 6)}, at(vec3(side * 3, 1.5f, 0)), vec3(0.7f));
        builder.add({Shape::Kind::box, vec3(6, 3, 0.2f)}, at(vec3(0, 1.5f, side * 3)), vec3(0.7f));
        builder.add({Shape::Kind::box, vec3(2.8f, 0.2f, 6)}, at(vec3(side * 1.6f, 3.1f, 0)), vec3(0.5f));
        builder.add({Shape::Kind::box, vec3(0.4f, 0.2f, 2.8f)}, at(vec3(0, 3.1f, side * 1.6f)), vec3(0.5f));
    }
    // Lights stand in the order of their kinds: the second one, which the first must be told from, is a point light.
    builder.add({.kind = kind, .position = vec3(0.1f, 3.6f, 0.1f), .direction = glm::normalize(vec3(0.05f, -1, 0.1f)), .intensity = vec3(100),
                 .outer_cone = 0.4f, .casts_shadow = true, .bounces = true});
    builder.add({.kind = Light::Kind::point, .position = vec3(1, 2, -1), .intensity = vec3(0.1f, 0.2f, 0.3f), .casts_shadow = true, .bounces = true});
    builder.look(vec3(-2, 1.5f, -2), vec3(1, -0.3f, 1), vec3(0, 1, 0), 1.2f);
    return builder.scene();
}

class LightPathsOf : public testing::TestWithParam<Light::Kind> {};

// That the mean is right to 0.2 % is shown by the closed forms of path_tracer_test.
TEST_P(LightPathsOf, LowerTheNoiseAndKeepTheMean) {
    SceneBuilder builder;
    RenderScene& scene = room(builder, GetParam());
    for (const TransportSettings& asked : {TransportSettings{.bounces = 1}, TransportSettings{.bounces = 1, .occlusion = false}, TransportSettings{}}) {
        glm::dvec3 mean[2];
        double noise[2];
        for (const bool with : {false, true}) {
            TransportSettings settings = asked;
            settings.light_paths = with;
            const Film film = trace_film(scene, {16, 12}, settings, 1024);
            glm::dvec3 sum(0.0);
            const auto layers = film.layers();
            const Image& irradiance = std::ranges::find(layers, "irradiance", &ImageLayer::name)->image;
            for (std::size_t i = 0; i < irradiance.data.size(); i += 3) sum += glm::dvec3(irradiance.data[i], irradiance.data[i + 1], irradiance.data[i + 2]);
            mean[with] = sum / (16.0 * 12.0);
            noise[with] = film.noise();
        }
        // Noise is that of a pixel; the mean is of 192.
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[1][c] / mean[0][c], 1.0, 4.0 * noise[0] / std::sqrt(192.0) + 1e-3) << "bounces " << asked.bounces << ", occlusion " << asked.occlusion;
        RecordProperty(fmt::format("noise_{}_{}", asked.bounces, asked.occlusion), fmt::format("{:.4f} -> {:.4f}", noise[0], noise[1]));
        EXPECT_LT(noise[1], noise[0]) << "bounces " << asked.bounces << ", occlusion " << asked.occlusion;
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, LightPathsOf, testing::Values(Light::Kind::directional, Light::Kind::spot, Light::Kind::point),
                         [](const auto& kind) { return std::string(kind.param == Light::Kind::directional ? "directional" : kind.param == Light::Kind::spot ? "spot" : "point"); });

}  // namespace
}  // namespace sl
