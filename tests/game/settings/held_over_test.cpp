// SPDX-License-Identifier: MIT
#include "game/settings/held_over.h"

#include <gtest/gtest.h>

namespace sl {
namespace {

TEST(HeldOver, AKeyOfTheMenuDoesNothingUntilItIsPressedAgain) {
    constexpr auto space = static_cast<std::size_t>(Key::space), w = static_cast<std::size_t>(Key::w);
    HeldOver held_over;
    Input window;
    window.keys_down.set(space);
    held_over.note(window);
    window.next_frame();
    window.keys_down.set(w);
    for (int frame = 0; frame < 3; ++frame) {
        Input input = window;
        held_over.remove_from(input);
        EXPECT_FALSE(input.active(Key::space));
        EXPECT_TRUE(input.active(Key::w)) << "other keys do";
        window.next_frame();
    }
    window.keys_pressed.set(space);
    Input again = window;
    held_over.remove_from(again);
    EXPECT_TRUE(again.down(Key::space) && again.pressed(Key::space));
}

TEST(HeldOver, ATapThatLeftTheMenuIsGone) {
    HeldOver held_over;
    Input window;
    window.keys_pressed.set(static_cast<std::size_t>(Key::space));
    held_over.note(window);
    window.next_frame();
    held_over.remove_from(window);
    EXPECT_FALSE(window.active(Key::space));
}

TEST(HeldOver, AGamepadsButtonsAreKeptBackToo) {
    HeldOver held_over;
    Input window;
    window.gamepad.buttons_down.set(static_cast<std::size_t>(GamepadButton::a));
    held_over.note(window);
    Input input = window;
    held_over.remove_from(input);
    EXPECT_FALSE(input.gamepad.down(GamepadButton::a));
    held_over.remove_from(window = {});
    window.gamepad.buttons_down.set(static_cast<std::size_t>(GamepadButton::a));
    held_over.remove_from(window);
    EXPECT_TRUE(window.gamepad.down(GamepadButton::a));
}

}  // namespace
}  // namespace sl
