// SPDX-License-Identifier: MIT
#include "engine/render/trace/light_meter.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "tests/support/closed_forms.h"
#include "tests/support/scene_builder.h"

namespace sl {
namespace {

const dvec3 on_the_floor(0.0);
const vec3 up(0, 1, 0);

mat4 ceiling(float height) { return glm::rotate(glm::translate(mat4(1.0f), vec3(0, height, 0)), glm::pi<float>(), vec3(1, 0, 0)); }

/// A square that faces down, one metre over the floor, in light that comes up through the floor.
class LightMeterUnderASquare : public testing::Test {
  protected:
    void SetUp() override {
        builder.add({Shape::Kind::quad, vec3(2)}, ceiling(1.0f), vec3(0.5f));
        builder.add({.kind = RenderScene::Light::Kind::directional, .direction = up, .intensity = vec3(1000.0f)});
    }
    LightMeter::Reading after(int frames) {
        std::optional<LightMeter::Reading> reading;
        for (int frame = 0; frame < frames; ++frame) {
            reading = meter.irradiance_at(on_the_floor, up);
            meter.update(builder.scene());
        }
        return reading.value_or(LightMeter::Reading{});
    }

    SceneBuilder builder;
    LightMeter meter;
    const float truth = static_cast<float>(500.0 * closed_form::parallel(-1, 1, -1, 1, 1));
};

TEST_F(LightMeterUnderASquare, ReadsTheClosedForm) {
    EXPECT_FALSE(meter.irradiance_at(on_the_floor, up));
    const auto reading = after(100);
    EXPECT_NEAR(reading.bounced.y, truth, 0.02f * truth);
    EXPECT_EQ(reading.bounced, reading.irradiance);
    EXPECT_LT(reading.noise, 0.02f);
    EXPECT_NEAR(reading.bounced.y, truth, 4.0f * reading.noise * truth);
    EXPECT_EQ(meter.irradiance_at(on_the_floor, -up), std::nullopt);
}

TEST_F(LightMeterUnderASquare, ForgetsOldLightAtOnceAfterAChange) {
    after(100);
    builder.scene().lights[0].intensity *= 10.0f;
    EXPECT_NEAR(after(10).bounced.y, 10.0f * truth, truth);
    builder.scene().lights[0].intensity = vec3(0.0f);
    EXPECT_EQ(after(3).bounced, vec3(0.0f));
}

TEST_F(LightMeterUnderASquare, FollowsSurfaces) {
    after(20);
    builder.add({Shape::Kind::quad, vec3(3)}, ceiling(0.5f), vec3(0.0f));
    EXPECT_EQ(after(3).bounced, vec3(0.0f));
    builder.move(1, ceiling(2.0f));
    EXPECT_NEAR(after(100).bounced.y, truth, 0.05f * truth);
}

TEST_F(LightMeterUnderASquare, WhatChangesFarOffCostsLittle) {
    builder.add({Shape::Kind::box, vec3(4)}, glm::translate(mat4(1.0f), vec3(90, 2, 0)), vec3(0.5f));
    const std::uint32_t before = after(25).paths;
    for (int frame = 0; frame < 10; ++frame) {
        builder.move(1, glm::translate(mat4(1.0f), vec3(90, 2, 5 * frame)));
        builder.scene().lights[0].direction = glm::normalize(vec3(0.001f * static_cast<float>(frame), 1, 0));
        after(1);
    }
    EXPECT_GE(after(1).paths, before);
    EXPECT_LT(after(1).paths, 2 * before) << "but what was far back counts no more";
    builder.move(1, glm::translate(mat4(1.0f), vec3(4, 2, 0)));
    EXPECT_LT(after(3).paths, before / 4) << "close by it is another matter";
}

TEST_F(LightMeterUnderASquare, GoesOnWhenTheOriginStepsOn) {
    const auto here = after(25);
    builder.scene().origin = dvec3(1024, 0, -1024);
    for (RenderScene::Draw& draw : builder.scene().draws) {
        draw.world_from_local[3] -= vec4(vec3(builder.scene().origin), 0.0f);
        draw.bounds = draw.bounds.moved(-vec3(builder.scene().origin));
    }
    const auto there = after(25);
    EXPECT_GT(there.paths, here.paths);
    EXPECT_NEAR(there.bounced.y, truth, 0.05f * truth);
}

TEST_F(LightMeterUnderASquare, IsSteadyWhileALightMovesAllTheTime) {
    after(30);
    float worst = 0.0f;
    for (int frame = 0; frame < 60; ++frame) {
        builder.scene().lights[0].intensity *= 1.001f;
        worst = std::max(worst, std::abs(after(1).bounced.y / (truth * std::pow(1.001f, static_cast<float>(frame))) - 1.0f));
    }
    EXPECT_LT(worst, 0.25f);
}

TEST_F(LightMeterUnderASquare, ReadsTheSameWhereverTheOriginIs) {
    const auto here = after(20);
    LightMeter far_off;
    builder.scene().origin = dvec3(4096.0, 0.0, -8192.0);
    std::optional<LightMeter::Reading> there;
    for (int frame = 0; frame < 20; ++frame) {
        there = far_off.irradiance_at(builder.scene().origin, up);
        far_off.update(builder.scene());
    }
    ASSERT_TRUE(there);
    EXPECT_NEAR(there->bounced.y, here.bounced.y, 0.1f * truth);
}

TEST_F(LightMeterUnderASquare, ForgetsWhatNobodyAsksFor) {
    after(20);
    for (int frame = 0; frame < 100; ++frame) meter.update(builder.scene());
    EXPECT_FALSE(meter.irradiance_at(on_the_floor, up));
}

TEST(LightMeter, TellsGlowFromWhatItsLightReflects) {
    SceneBuilder builder;
    Material glowing = SceneBuilder::matte(vec3(0.0f));
    glowing.emission = 100.0f;
    builder.add(make_shape_mesh({Shape::Kind::quad, vec3(2)}), ceiling(1.0f), glowing);
    LightMeter meter;
    std::optional<LightMeter::Reading> lamp_alone, with_a_wall;
    for (int frame = 0; frame < 50; ++frame) {
        lamp_alone = meter.irradiance_at(on_the_floor, up);
        meter.update(builder.scene());
    }
    const auto straight = static_cast<float>(100.0 * M_PI * closed_form::parallel(-1, 1, -1, 1, 1));
    EXPECT_NEAR(lamp_alone->irradiance.y, straight, 0.03f * straight);
    EXPECT_EQ(lamp_alone->bounced, vec3(0.0f));
    builder.add({Shape::Kind::box, vec3(0.1f, 1.0f, 2.0f)}, glm::translate(mat4(1.0f), vec3(0.5f, 0.5f, 0.0f)), vec3(0.8f));
    for (int frame = 0; frame < 50; ++frame) {
        with_a_wall = meter.irradiance_at(on_the_floor, up);
        meter.update(builder.scene());
    }
    EXPECT_GT(with_a_wall->bounced.y, 0.05f * straight);
    EXPECT_LT(with_a_wall->irradiance.y - with_a_wall->bounced.y, 0.9f * straight);
}

}  // namespace
}  // namespace sl
