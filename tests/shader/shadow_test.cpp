// SPDX-License-Identifier: MIT
// lib/shadow.glsl: maps whose depths the CPU wrote, seen from points whose answer is known by hand.
#include "engine/core/math.h"
#include "shared/lights.h"
#include "tests/shader/library_fixture.h"

namespace sl {
namespace {

constexpr std::uint32_t side = 8;
constexpr float free_way = 0.0f;  // reversed depth: infinitely far

class ShadowLibrary : public LibraryTest {
  protected:
    /// Layer 0 is blocked at `depth` where x < 4, layer 1 everywhere.
    void give_maps(float depth) {
        for (const char* name : {"shadow_sun", "shadow_spot"}) {
            gl::Texture& map = give_image(name, {.width = side, .height = side, .layers = 2, .format = Format::depth32f}, Sampling::shadow_compare);
            std::vector<float> half(side * side);
            for (std::size_t i = 0; i < half.size(); ++i) half[i] = i % side < side / 2 ? depth : free_way;
            upload(map, half, 0);
            upload(map, std::vector<float>(side * side, depth), 1);
        }
    }

    /// What `expression` of (light, incident, position, normal) gives at each position.
    std::vector<vec4> at(const std::string& expression, const LightParams& light, const std::vector<vec3>& positions, vec3 normal) {
        give("Light", light);
        give("Normal", vec4(normal, 0));
        std::vector<vec4> padded;
        for (const vec3& position : positions) padded.emplace_back(position, 1.0f);
        give("Positions", padded);
        return compute("#include \"lib/shadow.glsl\"\nlayout(std430) readonly buffer Light { LightParams light; };\n"
                       "layout(std430) readonly buffer Normal { vec4 normal; };\nlayout(std430) readonly buffer Positions { vec4 positions[]; };\n",
                       "    vec3 position = positions[i].xyz;\n    Incident incident = incident_light(light, position);\n    result = vec4(" + expression + ");",
                       positions.size());
    }
    std::vector<float> visibility(const char* kind, const LightParams& light, const std::vector<vec3>& positions, vec3 normal) {
        std::vector<float> values;
        for (const vec4& value : at(fmt::format("{}_visibility(light, incident, position, normal.xyz)", kind), light, positions, normal)) values.push_back(value.x);
        return values;
    }
};

/// Straight down from y = 10 to y = 0 on 8 × 8 m, a metre to the texel. Its map's x runs along world x.
LightParams sun(std::uint32_t layer, float texel) {
    LightParams light{};
    light.kind = uvec4(light_directional, layer, no_layer, 0);
    light.tiles = vec4(1, 0, 0, 1);
    light.direction = vec4(0, -1, 0, texel);
    light.intensity = vec4(1);
    light.map_clip_from_world = reversed_orthographic(4, 4, 0, 10) * view_from_world(vec3(0, 10, 0), vec3(0, -1, 0), vec3(0, 0, -1));
    return light;
}

/// From the origin along -z with a right angle to its edges: at distance d a map 2 d wide.
LightParams spot(std::uint32_t layer, float texel) {
    LightParams light{};
    light.kind = uvec4(light_spot, layer, no_layer, 0);
    light.direction = vec4(0, 0, -1, texel);
    light.intensity = vec4(1);
    light.cone = vec4(1, 0, 0, 0);
    light.map_clip_from_world = reversed_infinite_perspective(glm::radians(90.0f), 1.0f, 0.1f) * view_from_world(vec3(0), vec3(0, 0, -1), vec3(0, 1, 0));
    return light;
}

TEST_F(ShadowLibrary, SunIsBlockedBehindWhatTheMapHolds) {
    give_maps(0.4f);  // a roof at y = 4 over x < 0
    const std::vector<vec3> points{{-2, 0, 1}, {-2, 3.9f, 1}, {-2, 4.1f, 1}, {2, 0, 1}, {-3.4f, 1, -3.4f}};
    EXPECT_THAT(visibility("sun", sun(0, 0), points, vec3(0, 1, 0)), testing::ElementsAre(0, 0, 1, 1, 0));
    EXPECT_THAT(visibility("sun", sun(1, 0), points, vec3(0, 1, 0)), testing::ElementsAre(0, 0, 1, 0, 0)) << "the other layer";
    EXPECT_THAT(visibility("sun", sun(no_layer, 0), points, vec3(0, 1, 0)), testing::Each(1.0f)) << "casts no shadow";
}

TEST_F(ShadowLibrary, SunIsUnblockedOutsideItsMap) {
    give_maps(0.4f);
    const std::vector<vec3> outside{{-5, 0, 0}, {5, 0, 0}, {-2, 0, 9}, {-2, 0, -9}, {-100, 0, 100}};
    EXPECT_THAT(visibility("sun", sun(1, 0), outside, vec3(0, 1, 0)), testing::Each(1.0f));
}

TEST_F(ShadowLibrary, ShadowEdgeIsATexelWide) {
    give_maps(0.4f);
    // Between the middles of the last blocked and the first free texel.
    const auto values = visibility("sun", sun(0, 0), {{-0.5f, 0, 0}, {-0.25f, 0, 0}, {0, 0, 0}, {0.25f, 0, 0}, {0.5f, 0, 0}}, vec3(0, 1, 0));
    for (std::size_t i = 0; i < values.size(); ++i) EXPECT_NEAR(values[i], 0.25f * static_cast<float>(i), 1.0f / 256.0f) << "samplers weigh in 8 bits";
}

TEST_F(ShadowLibrary, SurfaceDoesNotShadowItself) {
    // A slope of 45° that the light sees, in a map of its own depths: each texel holds the slope's height at its middle.
    gl::Texture& map = give_image("shadow_sun", {.width = side, .height = side, .layers = 1, .format = Format::depth32f}, Sampling::shadow_compare);
    std::vector<float> depths(side * side);
    for (std::size_t i = 0; i < depths.size(); ++i) depths[i] = (5.0f + (static_cast<float>(i % side) - 3.5f)) / 10.0f;
    upload(map, depths);
    std::vector<vec3> on_slope;
    for (float x = -2.5f; x <= 2.5f; x += 0.01f) on_slope.emplace_back(x, 5.0f + x, 0.3f);
    EXPECT_THAT(visibility("sun", sun(0, 1), on_slope, glm::normalize(vec3(-1, 1, 0))), testing::Each(1.0f));
}

TEST_F(ShadowLibrary, PointsAreMovedByTheFiltersReach) {
    const auto coordinate = [&](float texel, vec3 normal) { return at(fmt::format("shadow_coordinate(light, incident, position, normal.xyz, {})", texel), sun(0, texel), {vec3(1, 2, 0)}, normal)[0]; };
    expect_close(coordinate(0.0f, vec3(0, 1, 0)), vec4(0.625f, 0.5f, 0.2f, 1), 1e-6f, 0);
    // Facing the light 0.2 texel along the normal and 0.5 towards the light; grazing 1.7 along the normal.
    expect_close(coordinate(0.5f, vec3(0, 1, 0)), vec4(0.625f, 0.5f, 0.2f + 0.35f / 10, 1), 1e-6f, 1);
    expect_close(coordinate(0.5f, vec3(1, 0, 0)), vec4(0.625f + 0.85f / 8, 0.5f, 0.2f + 0.25f / 10, 1), 1e-6f, 2);
}

TEST_F(ShadowLibrary, SpotIsBlockedBehindWhatTheMapHoldsAndDarkBehindItself) {
    give_maps(0.1f / 5.0f);  // a wall 5 m away where x < 0
    const std::vector<vec3> points{{-1, 0, -4.9f}, {-1, 0, -5.1f}, {-30, 0, -50}, {30, 0, -50}, {-1, 0, 5}, {1, 0, 5}, {1, 0, 0}};
    EXPECT_THAT(visibility("spot", spot(0, 0), points, vec3(0, 0, 1)), testing::ElementsAre(1, 0, 0, 1, 0, 0, 0));
    EXPECT_THAT(visibility("spot", spot(1, 0), points, vec3(0, 0, 1)), testing::ElementsAre(1, 0, 0, 0, 0, 0, 0)) << "the other layer";
    EXPECT_THAT(visibility("spot", spot(no_layer, 0), points, vec3(0, 0, 1)), testing::ElementsAre(1, 1, 1, 1, 0, 0, 0)) << "casts no shadow";
}

/// At (1, 2, 3), its faces a right angle wide and a texel more on each side.
LightParams point_light(std::uint32_t layer, float texel) {
    LightParams light{};
    light.kind = uvec4(light_point, layer, no_layer, 0);
    light.position = vec4(1, 2, 3, 0);
    light.direction = vec4(0, 0, 0, texel);
    light.intensity = vec4(1);
    light.tiles = vec4(0.1f, 1.0f + 2.0f / (side - 2), 0, 0);
    return light;
}

TEST_F(ShadowLibrary, PointLooksIntoTheFaceOfItsDirection) {
    // After a layer of another light's: faces that are blocked 1, 2, … 6 m away, so that a point's visibility tells its face.
    gl::Texture& map = give_image("shadow_point", {.width = side, .height = side, .layers = 7, .format = Format::depth32f}, Sampling::shadow_compare);
    for (std::uint32_t face = 0; face < 6; ++face) upload(map, std::vector<float>(side * side, 0.1f / static_cast<float>(face + 1)), face + 1);
    upload(map, std::vector<float>(side * side, 1.0f), 0);
    const std::vector<vec3> axes{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    std::vector<vec3> before, behind;
    for (std::size_t face = 0; face < 6; ++face) {
        const auto wall = static_cast<float>(face + 1);
        // Straight on, and as near to the face's corner as floats tell apart.
        for (const vec3 aside : {vec3(0), 0.999f * (vec3(1) - glm::abs(axes[face])), -0.999f * (vec3(1) - glm::abs(axes[face]))}) {
            before.push_back(vec3(1, 2, 3) + 0.99f * wall * (axes[face] + aside));
            behind.push_back(vec3(1, 2, 3) + 1.01f * wall * (axes[face] + aside));
        }
    }
    EXPECT_THAT(visibility("point", point_light(1, 0), before, vec3(0, 1, 0)), testing::Each(1.0f));
    EXPECT_THAT(visibility("point", point_light(1, 0), behind, vec3(0, 1, 0)), testing::Each(0.0f));
    EXPECT_THAT(visibility("point", point_light(no_layer, 0), behind, vec3(0, 1, 0)), testing::Each(1.0f)) << "casts no shadow";
    EXPECT_THAT(visibility("point", point_light(1, 0), {vec3(1, 2, 3)}, vec3(0, 1, 0)), testing::Each(1.0f)) << "in the light itself";
}

TEST_F(ShadowLibrary, SpotsTexelGrowsWithDistance) {
    give_maps(0.1f / 50.0f);  // a wall 50 m away, and a point 2 m inside it: little beside a texel, 13 m there
    const float texel = 2.0f / side;
    EXPECT_THAT(visibility("spot", spot(0, texel), {{-20, 0, -52}}, vec3(0, 0, 1)), testing::ElementsAre(1));
    EXPECT_THAT(visibility("spot", spot(0, 0), {{-20, 0, -52}}, vec3(0, 0, 1)), testing::ElementsAre(0)) << "without the move it would shadow itself";
}

}  // namespace
}  // namespace sl
