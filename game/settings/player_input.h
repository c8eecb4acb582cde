// SPDX-License-Identifier: MIT
#pragma once

#include "game/settings/user_settings.h"

namespace sl {

/// What the systems of the game read, made from what the window told: keys under their usual names, the mouse as quick as the
/// player wants it, and a gamepad as the keys, buttons and movements that it stands for. `seconds`: the frame's time.
Input player_input(const Input& window, const UserSettings& settings, double seconds);

struct GamepadControl {
    std::string_view name, help;
};
/// What the buttons do, for people.
std::span<const GamepadControl> gamepad_controls();

}  // namespace sl
