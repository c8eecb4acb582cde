// SPDX-License-Identifier: MIT
#include "engine/render/scene/sun_steps.h"

#include <gtest/gtest.h>

namespace sl {
namespace {

const vec3 morning = glm::normalize(vec3(0.3f, -1.0f, 0.2f)), later = glm::normalize(morning + vec3(0.004f, 0, 0)), evening = glm::normalize(vec3(-1.0f, -0.2f, 0));

/// A sun over a floor of some width, m.
RenderScene under_a_sun(float width, vec3 direction = morning) {
    RenderScene scene;
    scene.view = RenderScene::View{};
    scene.lights.push_back({.direction = direction, .casts_shadow = true, .shadow_size = 256, .shadow_distance = 64.0f});
    RenderScene::Draw draw;
    draw.bounds = {vec3(-0.5f * width, -1, -0.5f * width), vec3(0.5f * width, 1, 0.5f * width)};
    draw.content = 7;
    scene.bounds = draw.bounds;
    scene.draws.push_back(draw);
    return scene;
}

vec3 held(SunSteps& suns, const RenderScene& scene, bool at_once = false) { return suns.hold(scene, at_once).lights.front().direction; }

std::size_t next_layers(const SunSteps& suns) {
    LightTable table;
    suns.add_next_layers(table);
    return table.next_sun_layers.size();
}

TEST(SunSteps, ASmallStepWaitsForItsMap) {
    SunSteps suns;
    EXPECT_EQ(held(suns, under_a_sun(1000)), morning);
    EXPECT_EQ(next_layers(suns), 0u);
    EXPECT_EQ(held(suns, under_a_sun(1000, later)), morning);
    EXPECT_EQ(next_layers(suns), std::size_t{SunSquare::most_tiles * SunSquare::most_tiles});
    EXPECT_EQ(held(suns, under_a_sun(1000, later)), morning);
    suns.next_is_drawn();
    EXPECT_EQ(held(suns, under_a_sun(1000, later)), later);
    EXPECT_EQ(next_layers(suns), 0u);
    LightTable table;
    suns.add_next_layers(table);
    EXPECT_EQ(table.sun_array, 1u);
}

TEST(SunSteps, ASunThatNeverRestsComesOn) {
    SunSteps suns;
    vec3 wanted = morning, shown = held(suns, under_a_sun(1000));
    for (int i = 0; i < 100; ++i) {
        wanted = glm::normalize(wanted + vec3(0.001f, 0, 0));
        shown = held(suns, under_a_sun(1000, wanted));
        if (i % 8 == 7) suns.next_is_drawn();
        EXPECT_LT(glm::length(shown - wanted), 0.02f);
    }
    EXPECT_GT(glm::length(shown - morning), 0.05f);
}

TEST(SunSteps, AFarStepAPictureAndASmallSceneDoNotWait) {
    SunSteps suns;
    held(suns, under_a_sun(1000));
    EXPECT_EQ(held(suns, under_a_sun(1000, evening)), evening);
    EXPECT_EQ(held(suns, under_a_sun(1000, morning)), morning);
    EXPECT_EQ(held(suns, under_a_sun(1000, later), true), later);
    EXPECT_EQ(held(suns, under_a_sun(10)), morning);
    EXPECT_EQ(held(suns, under_a_sun(10, later)), later);
}

}  // namespace
}  // namespace sl
