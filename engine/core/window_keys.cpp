// SPDX-License-Identifier: MIT
#include "engine/core/window_keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace sl {

namespace {

struct KeyName {
    int glfw;
    Key key;
};
constexpr KeyName key_names[] = {{GLFW_KEY_SPACE, Key::space},
                                 {GLFW_KEY_ENTER, Key::enter},
                                 {GLFW_KEY_ESCAPE, Key::escape},
                                 {GLFW_KEY_TAB, Key::tab},
                                 {GLFW_KEY_LEFT, Key::left},
                                 {GLFW_KEY_RIGHT, Key::right},
                                 {GLFW_KEY_UP, Key::up},
                                 {GLFW_KEY_DOWN, Key::down},
                                 {GLFW_KEY_EQUAL, Key::plus},
                                 {GLFW_KEY_KP_ADD, Key::plus},
                                 {GLFW_KEY_MINUS, Key::minus},
                                 {GLFW_KEY_KP_SUBTRACT, Key::minus},
                                 {GLFW_KEY_LEFT_BRACKET, Key::left_bracket},
                                 {GLFW_KEY_RIGHT_BRACKET, Key::right_bracket},
                                 {GLFW_KEY_COMMA, Key::comma},
                                 {GLFW_KEY_PERIOD, Key::period},
                                 {GLFW_KEY_SLASH, Key::slash},
                                 {GLFW_KEY_BACKSLASH, Key::backslash},
                                 {GLFW_KEY_SEMICOLON, Key::semicolon},
                                 {GLFW_KEY_APOSTROPHE, Key::apostrophe},
                                 {GLFW_KEY_GRAVE_ACCENT, Key::grave_accent},
                                 {GLFW_KEY_BACKSPACE, Key::backspace},
                                 {GLFW_KEY_INSERT, Key::insert},
                                 {GLFW_KEY_HOME, Key::home},
                                 {GLFW_KEY_END, Key::end},
                                 {GLFW_KEY_PAGE_UP, Key::page_up},
                                 {GLFW_KEY_PAGE_DOWN, Key::page_down},
                                 {GLFW_KEY_LEFT_ALT, Key::alt},
                                 {GLFW_KEY_RIGHT_ALT, Key::alt},
                                 {GLFW_KEY_LEFT_SHIFT, Key::shift},
                                 {GLFW_KEY_RIGHT_SHIFT, Key::shift},
                                 {GLFW_KEY_LEFT_CONTROL, Key::control},
                                 {GLFW_KEY_RIGHT_CONTROL, Key::control}};

Key after(Key first, int steps) {
    return static_cast<Key>(static_cast<std::size_t>(first) + static_cast<std::size_t>(steps));
}

}  // namespace

std::optional<Key> key_of(int glfw_key) {
    if (glfw_key >= GLFW_KEY_A && glfw_key <= GLFW_KEY_Z) return after(Key::a, glfw_key - GLFW_KEY_A);
    if (glfw_key >= GLFW_KEY_0 && glfw_key <= GLFW_KEY_9) return after(Key::digit_0, glfw_key - GLFW_KEY_0);
    if (glfw_key >= GLFW_KEY_F1 && glfw_key <= GLFW_KEY_F12) return after(Key::f1, glfw_key - GLFW_KEY_F1);
    const auto found = std::ranges::find(key_names, glfw_key, &KeyName::glfw);
    return found != std::end(key_names) ? std::optional(found->key) : std::nullopt;
}

}  // namespace sl
