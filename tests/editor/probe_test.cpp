// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>

#include "editor/see/light_shares.h"
#include "editor/see/texel_shares.h"
#include "shared/octahedral.h"
#include "shared/rsm_texel.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

constexpr uvec2 size(64, 48);
const vec2 upwards = octahedral_encode(vec3(0, 1, 0)) * 0.5f + 0.5f;

/// A floor at height 0 seen from 2 m above, and a lamp 3 m above it.
class ProbeTest : public testing::Test {
  protected:
    ProbeTest() {
        builder.add({Shape::Kind::box, vec3(8, 1, 8)}, glm::translate(mat4(1.0f), vec3(0, -0.5f, 0)), vec3(0.5f));
        builder.look(vec3(0, 2, 0), vec3(0, -1, 0), vec3(0, 0, -1), 1.0f);
        scene().origin = dvec3(1024, 0, 0);
    }
    RenderScene& scene() { return builder.scene(); }
    FrameParams frame() { return frame_params(scene(), size.x, size.y, 0); }
    ProbedPoint at(vec3 place) { return {scene().origin + dvec3(place), vec3(0, 1, 0)}; }

    SceneBuilder builder;
};

TEST_F(ProbeTest, APixelIsWhereItsRayMeetsTheSurface) {
    for (const uvec2 pixel : {uvec2(0, 0), uvec2(31, 24), uvec2(63, 5)}) {
        const auto point = point_under(frame(), scene().origin, pixel, scene().view->near / 2.0f, upwards);
        ASSERT_TRUE(point);
        // Half the picture's height is tan(fov / 2) of the distance; a pixel's middle counts.
        const double metres = 2.0 * std::tan(0.5) * 2.0 / size.y;
        EXPECT_NEAR(point->position.x, 1024.0 + (pixel.x + 0.5 - size.x / 2.0) * metres, 1e-5);
        EXPECT_NEAR(point->position.y, 0.0, 1e-5);
        EXPECT_NEAR(point->position.z, (pixel.y + 0.5 - size.y / 2.0) * metres, 1e-5);
        EXPECT_NEAR(point->normal.y, 1.0f, 1e-6f);
    }
}

TEST_F(ProbeTest, ThePixelOfAPlaceIsTheOneThatShowsIt) {
    for (std::uint32_t x = 0; x < size.x; x += 7) {
        const uvec2 pixel(x, x % size.y);
        const auto seen = seen_at(frame(), scene().origin, point_under(frame(), scene().origin, pixel, scene().view->near / 2.0f, upwards)->position);
        ASSERT_TRUE(seen);
        EXPECT_EQ(seen->pixel, pixel);
        EXPECT_NEAR(seen->distance, 2.0f, 1e-5f);
    }
}

TEST_F(ProbeTest, TheSkyHasNoPointAndWhatLiesBehindNoPixel) {
    EXPECT_FALSE(point_under(frame(), scene().origin, uvec2(3), 0.0f, upwards));
    EXPECT_FALSE(seen_at(frame(), scene().origin, scene().origin + dvec3(0, 3, 0)));
    EXPECT_FALSE(seen_at(frame(), scene().origin, scene().origin + dvec3(50, 0, 0)));
    EXPECT_FALSE(seen_at(frame(), scene().origin, dvec3(std::numeric_limits<double>::quiet_NaN())));
}

TEST_F(ProbeTest, WhatStandsInFrontHides) {
    const SeenAt floor{uvec2(32, 24), 2.0f};
    EXPECT_TRUE(is_visible(frame(), floor, scene().view->near / 2.0f));
    EXPECT_FALSE(is_visible(frame(), floor, scene().view->near / 1.5f));
    EXPECT_TRUE(is_visible(frame(), floor, 0.0f)) << "before the sky";
}

TEST_F(ProbeTest, APointBelongsToTheEntityWhoseSurfaceItIsOn) {
    builder.add({Shape::Kind::box, vec3(1)}, glm::translate(mat4(1.0f), vec3(2, 0.5f, 0)), vec3(0.5f));
    const Entity floor{1, 1}, box{2, 1};
    scene().draws[0].entity = floor;
    scene().draws[1].entity = box;
    EXPECT_EQ(entity_at(scene(), vec3(-1, 0, 1)), floor);
    EXPECT_EQ(entity_at(scene(), vec3(2, 1, 0.1f)), box);
    EXPECT_EQ(entity_at(scene(), vec3(0, 1, 0)), Entity{});
}

TEST_F(ProbeTest, LightsBringWhatPhotometryTells) {
    builder.add({.kind = RenderScene::Light::Kind::directional, .direction = glm::normalize(vec3(3, -4, 0)), .intensity = vec3(100.0f)});
    builder.add({.kind = RenderScene::Light::Kind::point, .position = vec3(0, 3, 4), .intensity = vec3(5000.0f)});
    builder.add({.kind = RenderScene::Light::Kind::point, .position = vec3(0, -3, 0), .intensity = vec3(5000.0f)});
    const auto shares = light_shares(scene(), at(vec3(0)), nullptr);
    ASSERT_EQ(shares.size(), 2u) << "one lies behind the surface";
    EXPECT_NEAR(shares[0].irradiance.x, 5000.0f / 25.0f * 0.6f, 1e-3f);
    EXPECT_NEAR(shares[1].irradiance.x, 80.0f, 1e-3f);
    EXPECT_NEAR(glm::distance(shares[0].from, scene().origin + dvec3(0, 3, 4)), 0.0, 1e-4);
    EXPECT_NEAR(arriving(shares).x, 200.0f, 1e-3f);
}

TEST_F(ProbeTest, RaysFindWhatStandsBeforeALight) {
    builder.add({.kind = RenderScene::Light::Kind::spot, .position = vec3(0, 3, 0), .direction = vec3(0, -1, 0), .intensity = vec3(90.0f), .casts_shadow = true});
    builder.add({Shape::Kind::box, vec3(0.5f)}, glm::translate(mat4(1.0f), vec3(0, 1.5f, 0)), vec3(0.5f));
    const TransportWorld world(scene(), TransportSettings{});
    const auto under = light_shares(scene(), at(vec3(0)), &world), beside = light_shares(scene(), at(vec3(0.9f, 0, 0)), &world);
    ASSERT_EQ(under.size(), 1u);
    EXPECT_TRUE(under[0].blocked);
    EXPECT_NEAR(under[0].irradiance.x, 10.0f, 1e-3f);
    EXPECT_EQ(arriving(under), vec3(0.0f));
    ASSERT_EQ(beside.size(), 1u);
    EXPECT_FALSE(beside[0].blocked);
}

TEST_F(ProbeTest, TexelsBringTheLightOfDiscs) {
    // Two texels above the point that look down on it, 2 m and 4 m away, of 0.01 m² and 3 lm each; and an empty one.
    RsmLayer layer{Image(3, 1, 4), Image(3, 1, 4)};
    for (std::uint32_t i = 0; i < 2; ++i) {
        const float values[2][4] = {{0.0f, 4.0f - 2.0f * static_cast<float>(i), 0.0f, 0.01f}, {3.0f, 3.0f, 3.0f, pack_texel_normal(vec3(0, -1, 0))}};
        std::ranges::copy(values[0], layer.position.pixel(i, 0));
        std::ranges::copy(values[1], layer.flux.pixel(i, 0));
    }
    const auto disc = [](float distance) { return 3.0f / (pi * distance * distance + 0.01f); };
    const TexelShares shares = texel_shares({layer}, at(vec3(0)), scene().origin, 1);
    EXPECT_NEAR(shares.sum.x, disc(2.0f) + disc(4.0f), 1e-5f);
    ASSERT_EQ(shares.strongest.size(), 1u);
    EXPECT_NEAR(shares.strongest[0].irradiance.x, disc(2.0f), 1e-5f);
    EXPECT_EQ(shares.strongest[0].position, scene().origin + dvec3(0, 2, 0));
    EXPECT_TRUE(texel_shares({}, at(vec3(0)), scene().origin, 32).strongest.empty());
}

}  // namespace
}  // namespace sl
