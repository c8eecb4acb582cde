// SPDX-License-Identifier: MIT
#include "engine/core/gamepad.h"

#include <algorithm>
#include <cmath>

namespace sl {

namespace {

/// Pulled so far, a trigger goes down and up again; apart, so that a finger that trembles does not press twice.
constexpr float pulled = 0.2f, released = -0.2f;

bool trigger_down(bool before, float reading) {
    return reading > (before ? released : pulled);
}

vec2 finite(vec2 stick) {
    return std::isfinite(stick.x) && std::isfinite(stick.y) ? glm::clamp(stick, -1.0f, 1.0f) : vec2(0.0f);
}

}  // namespace

Gamepad gamepad_after(const Gamepad& before, const GamepadReading& reading) {
    Gamepad now{.connected = true,
                .left_stick = finite(reading.left_stick) * vec2(1, -1),
                .right_stick = finite(reading.right_stick) * vec2(1, -1),
                .buttons_down = reading.buttons};
    const auto set_trigger = [&](GamepadButton trigger, float pull) {
        now.buttons_down.set(static_cast<std::size_t>(trigger), trigger_down(before.down(trigger), pull));
    };
    set_trigger(GamepadButton::left_trigger, reading.left_trigger);
    set_trigger(GamepadButton::right_trigger, reading.right_trigger);
    now.buttons_pressed = now.buttons_down & ~before.buttons_down;
    return now;
}

vec2 past_dead_zone(vec2 stick, float dead_zone) {
    const float length = glm::length(stick);
    if (!(length > dead_zone) || dead_zone >= 1.0f) return vec2(0.0f);
    return stick * (std::min((length - dead_zone) / (1.0f - dead_zone), 1.0f) / length);
}

}  // namespace sl
