// SPDX-License-Identifier: MIT
#include "shared/water.h"

#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/gl_test.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

TEST(WaterOptics, FresnelEndsAtTheKnownValues) {
    EXPECT_NEAR(water_fresnel(1.0f, 0.0f), 0.0201f, 1e-4f);
    EXPECT_NEAR(water_fresnel(0.0f, 0.0f), 1.0f, 1e-6f);
    EXPECT_NEAR(water_fresnel(1.0f, 1.0f), 0.0201f, 1e-4f);
    // The critical angle is asin(1 / 1.33) = 48.75 deg.
    EXPECT_EQ(water_fresnel(std::cos(glm::radians(48.8f)), 1.0f), 1.0f);
    EXPECT_LT(water_fresnel(std::cos(glm::radians(47.0f)), 1.0f), 0.5f);
}

TEST(WaterOptics, FresnelIsTheSameBothWays) {
    for (float degrees = 0.0f; degrees < 85.0f; degrees += 5.0f) {
        const float in_air = glm::radians(degrees), in_water = std::asin(std::sin(in_air) / water_index);
        EXPECT_NEAR(water_fresnel(std::cos(in_air), 0.0f), water_fresnel(std::cos(in_water), 1.0f), 1e-3f) << degrees;
    }
}

TEST(WaterOptics, TransmissionMultipliesOverTheWay) {
    const vec3 absorption(0.3f, 0.1f, 0.05f);
    const vec3 one = water_transmission(absorption, 1.0f), three = water_transmission(absorption, 3.0f);
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(one[channel], std::exp(-absorption[channel]), 1e-6f);
        EXPECT_NEAR(three[channel], one[channel] * one[channel] * one[channel], 1e-6f);
    }
}

TEST(WaterOptics, RipplesRepeatEachMinuteAndVanishFarOff) {
    const vec2 at(3.7f, -1.2f);
    const vec3 now = water_slope(at, 12.5f, 0.0f), later = water_slope(at, 72.5f, 0.0f);
    EXPECT_NEAR(now.x, later.x, 1e-4f);
    EXPECT_NEAR(now.y, later.y, 1e-4f);
    EXPECT_EQ(now.z, 0.0f);
    const vec3 far = water_slope(at, 12.5f, 100.0f);
    EXPECT_NEAR(glm::length(vec2(far.x, far.y)), 0.0f, 1e-6f);
    EXPECT_GT(far.z, 0.0f);
}

/// A camera that looks down, and a glowing ground two metres under where water may be.
class Water : public GlTest {
  protected:
    void SetUp() override {
        GlTest::SetUp();
        builder.look(vec3(0, 3, 0), vec3(0, -1, 0), vec3(0, 0, -1), 0.2f);
        Material glowing = SceneBuilder::matte(vec3(0));
        glowing.emission = 100.0f;
        builder.add(make_shape_mesh({Shape::Kind::box, vec3(20, 1, 20)}), glm::translate(mat4(1.0f), vec3(0, -2.5f, 0)), glowing);
        builder.use(GiOff{});
    }
    void flood() {
        builder.add(make_shape_mesh({Shape::Kind::box, vec3(18, 1.9f, 18)}), glm::translate(mat4(1.0f), vec3(0, -0.95f, 0)), Material{});
        RenderScene& scene = builder.scene();
        scene.waters.push_back(scene.draws.back());
        scene.draws.pop_back();
    }
    bool has_pass(const std::string& name) const {
        return std::ranges::any_of(renderer.steps(), [&](const Step& step) { return renderer.graph().passes()[static_cast<std::size_t>(step.pass)].name == name; });
    }
    Image draw(const std::string& image, double time = 0.0) {
        const auto result = renderer.render(builder.scene(), {.width = 33, .height = 21, .time = time, .wanted = {image}});
        return renderer.read(image == "final" ? result.images.final : renderer.find_image(image));
    }

    SceneBuilder builder;
    Renderer renderer{shader_folder()};
};

TEST_F(Water, NoneCostsNothing) {
    draw("hdr");
    EXPECT_FALSE(has_pass("water"));
    EXPECT_FALSE(has_pass("water_surface"));
    flood();
    builder.look(vec3(0, 3, 0), vec3(0, 1, 0), vec3(0, 0, -1), 0.2f);
    draw("hdr");
    EXPECT_FALSE(has_pass("water")) << "none is in view";
}

TEST_F(Water, AWindowsFirstFrameMakesItsPrograms) {
    flood();
    builder.look(vec3(0, 3, 0), vec3(0, 1, 0), vec3(0, 0, -1), 0.2f);
    const auto draw_in_window = [&] { renderer.render(builder.scene(), {.width = 33, .height = 21, .slice_budget = 1}); };
    draw_in_window();
    EXPECT_TRUE(has_pass("water")) << "which no player waits for later";
    draw_in_window();
    EXPECT_FALSE(has_pass("water"));
}

TEST_F(Water, TheGroundIsSeenThroughItByBeerLambertAndFresnel) {
    flood();
    const Image seen = draw("hdr_water"), without = draw("hdr");
    EXPECT_TRUE(has_pass("water"));
    const float reflected = water_fresnel(1.0f, 0.0f);
    for (int channel = 0; channel < 3; ++channel) {
        const auto at = static_cast<std::size_t>(channel);
        const float left = seen.pixel(16, 10)[at] / without.pixel(16, 10)[at];
        const vec3 through = water_transmission(vec3(0.3f, 0.075f, 0.05f), 2.0f);
        EXPECT_NEAR(left, (1.0f - reflected) * through[channel], 0.01f);
    }
    EXPECT_NEAR(without.pixel(16, 10)[0], 100.0f, 0.1f) << "light itself passes unchanged";
}

TEST_F(Water, UnderWaterAllIsTinted) {
    builder.scene().view->in_water = true;
    const Image seen = draw("hdr_water");
    const vec3 through = water_transmission(vec3(0.3f, 0.075f, 0.05f), 5.0f);
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(seen.pixel(16, 10)[channel], 100.0f * through[channel], 1.0f);
}

TEST_F(Water, RipplesWithTimeAlone) {
    flood();
    builder.look(vec3(0, 0.5f, 6), vec3(0, -0.2f, -1), vec3(0, 1, 0), 1.0f);
    builder.scene().sky_radiance = vec3(50.0f, 80.0f, 120.0f);
    const Image first = draw("hdr_water"), again = draw("hdr_water"), later = draw("hdr_water", 0.4);
    EXPECT_EQ(first.data, again.data);
    EXPECT_NE(first.data, later.data);
    for (const float value : later.data) ASSERT_TRUE(std::isfinite(value) && value >= 0.0f);
}

}  // namespace
}  // namespace sl
