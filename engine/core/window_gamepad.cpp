// SPDX-License-Identifier: MIT
#include "engine/core/window_gamepad.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace sl {

// The buttons are taken over by number.
static_assert(GLFW_GAMEPAD_BUTTON_A == static_cast<int>(GamepadButton::a));
static_assert(GLFW_GAMEPAD_BUTTON_START == static_cast<int>(GamepadButton::start));
static_assert(GLFW_GAMEPAD_BUTTON_LAST == static_cast<int>(GamepadButton::left));

std::optional<GamepadReading> read_gamepad() {
    for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
        GLFWgamepadstate state{};
        if (glfwGetGamepadState(joystick, &state) == GLFW_FALSE) continue;
        GamepadReading reading;
        for (std::size_t i = 0; i <= GLFW_GAMEPAD_BUTTON_LAST; ++i) reading.buttons.set(i, state.buttons[i] == GLFW_PRESS);
        reading.left_stick = {state.axes[GLFW_GAMEPAD_AXIS_LEFT_X], state.axes[GLFW_GAMEPAD_AXIS_LEFT_Y]};
        reading.right_stick = {state.axes[GLFW_GAMEPAD_AXIS_RIGHT_X], state.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]};
        reading.left_trigger = state.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER];
        reading.right_trigger = state.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER];
        return reading;
    }
    return std::nullopt;
}

}  // namespace sl
