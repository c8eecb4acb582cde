// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>

#include "engine/core/input.h"

namespace sl {

/// What a player can put on another key.
// clang-format off
enum class Action : std::size_t {
    forward, back, left, right, jump, crouch, run, fly, rise, sink, flashlight, hint,
    next_gi_method, gi_on_off, sun_left, sun_right, drag_sun, day_on_off, brighter, darker,
    panel, help, fullscreen, picture
};
// clang-format on
inline constexpr std::size_t action_count = static_cast<std::size_t>(Action::picture) + 1;

struct ActionInfo {
    std::string_view name;
    Key usual;  ///< the key under which systems know the action, wherever the player has put it
    std::string_view help;
};

/// In the order of Action.
inline constexpr std::array<ActionInfo, action_count> actions{{
    {"forward", Key::w, "Walk or fly forward."},
    {"back", Key::s, "Walk or fly back."},
    {"left", Key::a, "Walk or fly to the left."},
    {"right", Key::d, "Walk or fly to the right."},
    {"jump", Key::space, "Jump, and swim up."},
    {"crouch", Key::c, "Crouch, and dive."},
    {"run", Key::shift, "Run, and fly faster."},
    {"fly", Key::v, "Fly, and walk again."},
    {"rise", Key::e, "Fly up."},
    {"sink", Key::q, "Fly down."},
    {"flashlight", Key::f, "Flashlight on and off."},
    {"hint", Key::t, "Hint for the nearest crystal."},
    {"next_gi_method", Key::g, "Next method of indirect light."},
    {"gi_on_off", Key::o, "Indirect light off and on."},
    {"sun_left", Key::left_bracket, "Turn the sun to the left; so does the left arrow."},
    {"sun_right", Key::right_bracket, "Turn the sun to the right; so does the right arrow."},
    {"drag_sun", Key::m, "While held, the mouse drags the sun round the sky."},
    {"day_on_off", Key::n, "Stop the day, and let it go on."},
    {"brighter", Key::plus, "Brighten the picture."},
    {"darker", Key::minus, "Darken the picture."},
    {"panel", Key::f1, "Editor panel."},
    {"help", Key::h, "List of the keys."},
    {"fullscreen", Key::f11, "Fill the screen, or not."},
    {"picture", Key::f12, "Save a picture into out/."},
}};

constexpr const ActionInfo& action_info(Action action) { return actions[static_cast<std::size_t>(action)]; }

}  // namespace sl
