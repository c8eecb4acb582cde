// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bitset>
#include <cstddef>

#include "engine/core/math.h"

namespace sl {

/// Named as on an Xbox pad, by where they lie; the triggers count as buttons too.
// clang-format off
enum class GamepadButton : std::size_t {
    a, b, x, y, left_bumper, right_bumper, back, start, guide, left_thumb, right_thumb, up, right, down, left,
    left_trigger, right_trigger
};
// clang-format on
inline constexpr std::size_t gamepad_button_count = static_cast<std::size_t>(GamepadButton::right_trigger) + 1;

/// What a driver tells of a gamepad at one moment.
struct GamepadReading {
    std::bitset<gamepad_button_count> buttons;       ///< the triggers' bits are not looked at
    vec2 left_stick{0.0f}, right_stick{0.0f};        ///< right and down, -1 to 1
    float left_trigger = -1.0f, right_trigger = -1.0f;  ///< -1 is released, 1 is pulled
};

/// A gamepad as plain data, a part of Input.
struct Gamepad {
    bool connected = false;
    vec2 left_stick{0.0f}, right_stick{0.0f};  ///< right and up, -1 to 1, as measured: at rest they are not quite 0
    std::bitset<gamepad_button_count> buttons_down;
    std::bitset<gamepad_button_count> buttons_pressed;  ///< went down since the last frame

    bool down(GamepadButton button) const { return buttons_down[static_cast<std::size_t>(button)]; }
    bool pressed(GamepadButton button) const { return buttons_pressed[static_cast<std::size_t>(button)]; }
};

/// The gamepad a frame later.
Gamepad gamepad_after(const Gamepad& before, const GamepadReading& reading);

/// A stick without its rest position: 0 inside the dead zone, from there evenly to length 1 at its end.
vec2 past_dead_zone(vec2 stick, float dead_zone);

}  // namespace sl
