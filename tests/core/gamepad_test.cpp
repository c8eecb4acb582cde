// SPDX-License-Identifier: MIT
#include "engine/core/gamepad.h"

#include <gtest/gtest.h>

#include <limits>

namespace sl {
namespace {

TEST(Gamepad, AButtonIsPressedOnceAndHeldOn) {
    GamepadReading reading;
    Gamepad pad = gamepad_after({}, reading);
    EXPECT_TRUE(pad.connected);
    EXPECT_FALSE(pad.down(GamepadButton::a));
    reading.buttons.set(static_cast<std::size_t>(GamepadButton::a));
    pad = gamepad_after(pad, reading);
    EXPECT_TRUE(pad.pressed(GamepadButton::a) && pad.down(GamepadButton::a));
    pad = gamepad_after(pad, reading);
    EXPECT_FALSE(pad.pressed(GamepadButton::a));
    EXPECT_TRUE(pad.down(GamepadButton::a));
}

TEST(Gamepad, ATriggerThatTremblesIsPulledOnce) {
    Gamepad pad;
    int presses = 0;
    for (const float pull : {-1.0f, 0.1f, 0.3f, 0.1f, 0.3f, 0.0f, -0.1f, 0.9f, -0.5f, 0.5f}) {
        pad = gamepad_after(pad, {.right_trigger = pull});
        presses += pad.pressed(GamepadButton::right_trigger);
    }
    EXPECT_EQ(presses, 2);
    EXPECT_FALSE(pad.down(GamepadButton::left_trigger));
}

TEST(Gamepad, SticksPointUpAndNonsenseIsRest) {
    const Gamepad pad = gamepad_after({}, {.left_stick = {0.5f, 1.5f}, .right_stick = {std::numeric_limits<float>::quiet_NaN(), 1.0f}});
    EXPECT_EQ(pad.left_stick, vec2(0.5f, -1.0f));
    EXPECT_EQ(pad.right_stick, vec2(0.0f));
}

TEST(Gamepad, TheDeadZoneIsRoundAndWhatIsOutsideBeginsAtZero) {
    EXPECT_EQ(past_dead_zone({0.1f, -0.1f}, 0.15f), vec2(0.0f));
    EXPECT_NEAR(glm::length(past_dead_zone({0.16f, 0.0f}, 0.15f)), 0.0118f, 1e-3f);
    EXPECT_NEAR(past_dead_zone({0.0f, -1.0f}, 0.15f).y, -1.0f, 1e-6f);
    EXPECT_NEAR(glm::length(past_dead_zone({1.0f, 1.0f}, 0.15f)), 1.0f, 1e-6f) << "a corner is no further than a side";
    EXPECT_EQ(past_dead_zone({1.0f, 0.0f}, 1.0f), vec2(0.0f));
}

}  // namespace
}  // namespace sl
