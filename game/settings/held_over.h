// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/input.h"

namespace sl {

/// Keys and buttons that were held when a menu was left: they do nothing until they are let go, so that the Space that chose
/// "Resume" is no jump.
class HeldOver {
  public:
    /// In each frame of the menu.
    void note(const Input& input) {
        keys_ = input.keys_down | input.keys_pressed;
        buttons_ = input.gamepad.buttons_down;
    }
    /// In each frame of the game.
    void remove_from(Input& input) {
        input.keys_before &= ~keys_;
        keys_ &= input.keys_down & ~input.keys_pressed;
        input.keys_down &= ~keys_;
        buttons_ &= input.gamepad.buttons_down & ~input.gamepad.buttons_pressed;
        input.gamepad.buttons_down &= ~buttons_;
    }

  private:
    std::bitset<key_count> keys_;
    std::bitset<gamepad_button_count> buttons_;
};

}  // namespace sl
