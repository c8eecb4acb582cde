// SPDX-License-Identifier: MIT
#include "game/settings/player_input.h"

#include "game/fly_camera.h"

namespace sl {

namespace {

constexpr float quickest_turn = 3.5f;  ///< rad/s, of a stick at its end

/// A button and the key whose action it does.
constexpr std::pair<GamepadButton, Action> button_actions[] = {
    {GamepadButton::a, Action::jump}, {GamepadButton::b, Action::crouch}, {GamepadButton::y, Action::flashlight}, {GamepadButton::left_thumb, Action::run}};
constexpr std::pair<GamepadButton, MouseButton> button_clicks[] = {
    {GamepadButton::right_trigger, MouseButton::left}, {GamepadButton::left_trigger, MouseButton::right}, {GamepadButton::x, MouseButton::middle}};

constexpr GamepadControl controls_text[] = {{"left stick", "walk, fly"},
                                            {"right stick", "look round"},
                                            {"A", "jump, swim up"},
                                            {"B", "crouch, dive"},
                                            {"X", "take the kind of block"},
                                            {"Y", "flashlight"},
                                            {"right trigger", "break a block"},
                                            {"left trigger", "place a block"},
                                            {"bumpers", "choose a block"},
                                            {"left stick, pressed", "run"},
                                            {"start", "menu"}};

/// Fine near the middle, quick at the end.
vec2 curved(vec2 stick) { return stick * glm::length(stick); }

void press_keys(Input& input) {
    for (const auto& [button, action] : button_actions) {
        const auto key = static_cast<std::size_t>(action_info(action).usual);
        if (input.gamepad.down(button)) input.keys_down.set(key);
        if (input.gamepad.pressed(button)) input.keys_pressed.set(key);
    }
    for (const auto& [button, click] : button_clicks) {
        if (input.gamepad.down(button)) input.buttons_down.set(static_cast<std::size_t>(click));
        if (input.gamepad.pressed(button)) input.buttons_pressed.set(static_cast<std::size_t>(click));
    }
    input.scroll += static_cast<float>(input.gamepad.pressed(GamepadButton::left_bumper)) - static_cast<float>(input.gamepad.pressed(GamepadButton::right_bumper));
}

void move_sticks(Input& input, const ControlSettings& controls, double seconds) {
    input.stick = past_dead_zone(input.gamepad.left_stick, controls.dead_zone);
    const vec2 turn = curved(past_dead_zone(input.gamepad.right_stick, controls.dead_zone)) * vec2(1, -1);
    const float radians = quickest_turn * controls.gamepad_sensitivity * static_cast<float>(seconds);
    input.mouse_delta += turn * (radians / FlyCamera{}.radians_per_unit);
}

}  // namespace

Input player_input(const Input& window, const UserSettings& settings, double seconds) {
    Input input = with_usual_keys(window, settings.keys);
    input.mouse_delta *= settings.controls.mouse_sensitivity;
    if (input.gamepad.connected) {
        press_keys(input);
        move_sticks(input, settings.controls, seconds);
        input.mouse_captured = true;  // a stick aims as a captured mouse does
    }
    if (settings.controls.invert_y) input.mouse_delta.y = -input.mouse_delta.y;
    return input;
}

std::span<const GamepadControl> gamepad_controls() { return controls_text; }

}  // namespace sl
