// SPDX-License-Identifier: MIT
#include "game/light_keys.h"

#include <gtest/gtest.h>

#include "engine/core/clock.h"
#include "engine/core/input.h"
#include "engine/ecs/components.h"
#include "game/notice.h"

namespace sl {
namespace {

class LightKeysTest : public testing::Test {
  protected:
    App app_;
    Entity camera_ = app_.world.create(Camera{}, GiSettings{RsmGrid{.strength = 0.7f}});
    Entity sun_ = app_.world.create(SunAngles{.azimuth = 0.0f, .elevation = 0.5f}, DirectionalLight{});

    LightKeysTest() {
        app_.world.add_resource(FrameClock{});
        add_light_keys(app_);
    }
    void press(Key key, double step = 0.01) {
        app_.world.resource<FrameClock>().step = step;
        auto& input = app_.world.resource<Input>();
        input.keys_pressed.set(static_cast<std::size_t>(key));
        app_.schedule.run(app_.world);
        input.keys_pressed.reset();
    }
    const GiMethod& method() { return app_.world.get<GiSettings>(camera_).method; }
};

TEST_F(LightKeysTest, GComesRoundThroughAllMethodsAndFindsSettingsAgain) {
    const std::size_t first = gi_method_index(method());
    for (std::size_t i = 1; i <= gi_method_names().size(); ++i) {
        press(Key::g);
        EXPECT_EQ(gi_method_index(method()), (first + i) % gi_method_names().size());
    }
    EXPECT_EQ(method().get<RsmGrid>().strength, 0.7f);
    EXPECT_NE(app_.world.resource<Notice>().text.find("rsm_grid"), std::string::npos);
}

TEST_F(LightKeysTest, OTurnsOffAndBackOn) {
    press(Key::o);
    EXPECT_TRUE(method().is<GiOff>());
    press(Key::o);
    EXPECT_EQ(method().get<RsmGrid>().strength, 0.7f);
}

TEST_F(LightKeysTest, OGivesACameraWithoutSettingsTheUsualOnes) {
    app_.world.remove<GiSettings>(camera_);
    press(Key::o);
    EXPECT_EQ(method().name(), GiSettings{}.method.name());
}

TEST_F(LightKeysTest, SunTurnsByTimeAndStaysInItsRange) {
    const auto& sun = app_.world.get<SunAngles>(sun_);
    press(Key::right_bracket, 0.1);
    const float step = sun.azimuth;
    EXPECT_GT(step, 0.0f);
    press(Key::left, 0.1);
    EXPECT_NEAR(sun.azimuth, 0.0f, 1e-6f);
    for (int i = 0; i < 200; ++i) press(Key::left_bracket, 0.1);
    EXPECT_LE(std::abs(sun.azimuth), pi + 1e-5f);
    for (int i = 0; i < 200; ++i) press(Key::up, 0.1);
    EXPECT_LE(sun.elevation, 0.5f * pi);
    for (int i = 0; i < 400; ++i) press(Key::down, 0.1);
    EXPECT_GE(sun.elevation, -0.5f * pi);
}

TEST_F(LightKeysTest, WhileMIsHeldTheMouseDragsTheSunAndNothingElse) {
    const auto& sun = app_.world.get<SunAngles>(sun_);
    auto& input = app_.world.resource<Input>();
    input.mouse_delta = vec2(100.0f, -50.0f);
    app_.schedule.run(app_.world);
    EXPECT_EQ(sun.azimuth, 0.0f);
    EXPECT_NE(input.mouse_delta, vec2(0.0f));
    press(Key::m);
    EXPECT_GT(sun.azimuth, 0.0f);
    EXPECT_GT(sun.elevation, 0.5f) << "the mouse went up";
    EXPECT_EQ(input.mouse_delta, vec2(0.0f)) << "the view turns as well";
}

TEST_F(LightKeysTest, NStopsTheDayAndLetsItGoOn) {
    press(Key::n);
    EXPECT_NE(app_.world.resource<Notice>().text.find("stands still"), std::string::npos);
    app_.world.add(sun_, DayCycle{.runs = true, .hour = 9.5});
    press(Key::n);
    EXPECT_FALSE(app_.world.get<DayCycle>(sun_).runs);
    EXPECT_NE(app_.world.resource<Notice>().text.find("09:30"), std::string::npos);
    press(Key::n);
    EXPECT_TRUE(app_.world.get<DayCycle>(sun_).runs);
}

TEST_F(LightKeysTest, PlusBrightensAndEndsAtTheRange) {
    auto& camera = app_.world.get<Camera>(camera_);
    const float before = camera.ev100;
    press(Key::plus, 0.1);
    EXPECT_LT(camera.ev100, before);
    for (int i = 0; i < 1000; ++i) press(Key::minus, 0.1);
    EXPECT_EQ(camera.ev100, 24.0f);
}

TEST_F(LightKeysTest, WithoutACameraOnlyTheSunTurns) {
    app_.world.destroy(camera_);
    for (const Key key : {Key::g, Key::o, Key::plus, Key::right}) press(key, 0.1);
    EXPECT_GT(app_.world.get<SunAngles>(sun_).azimuth, 0.0f);
}

}  // namespace
}  // namespace sl
