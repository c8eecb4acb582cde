// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <filesystem>
#include <vector>

#include "engine/core/gamepad.h"

namespace sl {

/// Keys by where they lie on a US keyboard, so that WASD is under the same fingers everywhere.
// clang-format off
enum class Key : std::size_t {
    a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
    digit_0, digit_1, digit_2, digit_3, digit_4, digit_5, digit_6, digit_7, digit_8, digit_9,
    f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12,
    space, enter, escape, tab, left, right, up, down, plus, minus, left_bracket, right_bracket,
    comma, period, slash, backslash, semicolon, apostrophe, grave_accent,
    backspace, insert, home, end, page_up, page_down,
    alt, shift, control
};
// clang-format on
inline constexpr std::size_t key_count = static_cast<std::size_t>(Key::control) + 1;

/// A value is the button's bit in Input.
enum class MouseButton : std::size_t { left, right, middle };
inline constexpr std::size_t mouse_button_count = 3;

/// What people did since the last frame, as plain data; a resource. Systems read it and never ask the window.
struct Input {
    std::bitset<key_count> keys_down;     ///< held now
    std::bitset<key_count> keys_pressed;  ///< went down since the last frame, even if up again by now
    std::bitset<key_count> keys_before;   ///< held when the last frame ended
    std::bitset<mouse_button_count> buttons_down;
    std::bitset<mouse_button_count> buttons_pressed;
    vec2 mouse_delta{0.0f};       ///< screen units, right and down; only while the mouse is captured
    float scroll = 0.0f;          ///< notches, away from the user
    bool mouse_captured = false;  ///< the pointer is hidden and turns the view
    Gamepad gamepad;
    std::vector<std::filesystem::path> dropped;  ///< files that were let fall onto the window
    vec2 stick{0.0f};  ///< right and forward, -1 to 1: how far a gamepad's stick asks to walk, beside the keys

    bool down(Key key) const { return keys_down[static_cast<std::size_t>(key)]; }
    /// Went down since the last frame.
    bool pressed(Key key) const { return keys_pressed[static_cast<std::size_t>(key)]; }
    /// Held at some time since the last frame, however short: for what goes on as long as a key is down.
    bool active(Key key) const {
        return down(key) || pressed(key) || keys_before[static_cast<std::size_t>(key)];
    }
    bool pressed(MouseButton button) const { return buttons_pressed[static_cast<std::size_t>(button)]; }
    /// 1, -1 or 0: which of two opposite keys is active.
    float axis(Key positive, Key negative) const {
        return static_cast<float>(active(positive)) - static_cast<float>(active(negative));
    }

    /// As if no key had been touched: somebody else has them.
    void ignore_keys() {
        keys_down.reset();
        keys_pressed.reset();
        keys_before.reset();
    }
    void ignore_mouse() {
        buttons_down.reset();
        buttons_pressed.reset();
        mouse_delta = vec2(0.0f);
        scroll = 0.0f;
    }
    /// Forgets what happened in a moment and keeps what is held.
    void next_frame() {
        keys_before = keys_down;
        keys_pressed.reset();
        dropped.clear();
        buttons_pressed.reset();
        mouse_delta = vec2(0.0f);
        scroll = 0.0f;
    }
};

}  // namespace sl
