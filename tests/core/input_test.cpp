// SPDX-License-Identifier: MIT
#include "engine/core/input.h"

#include <gtest/gtest.h>

namespace sl {
namespace {

void press(Input& input, Key key) {
    input.keys_down.set(static_cast<std::size_t>(key));
    input.keys_pressed.set(static_cast<std::size_t>(key));
}
void release(Input& input, Key key) {
    input.keys_down.reset(static_cast<std::size_t>(key));
}

TEST(Input, ATapBetweenTwoFramesIsNotLost) {
    Input input;
    press(input, Key::w);
    release(input, Key::w);
    EXPECT_FALSE(input.down(Key::w));
    EXPECT_TRUE(input.pressed(Key::w));
    EXPECT_EQ(input.axis(Key::w, Key::s), 1.0f);
    input.next_frame();
    EXPECT_FALSE(input.active(Key::w));
}

TEST(Input, AModifierReleasedInTheFrameOfItsKeyStillCounts) {
    Input input;
    press(input, Key::control);
    input.next_frame();
    press(input, Key::q);
    release(input, Key::q);
    release(input, Key::control);
    EXPECT_TRUE(input.active(Key::control) && input.pressed(Key::q));
    input.next_frame();
    EXPECT_FALSE(input.active(Key::control));
}

TEST(Input, HeldKeysStayAndMomentsPass) {
    Input input;
    press(input, Key::a);
    input.buttons_pressed.set(0);
    input.mouse_delta = vec2(1, 2);
    input.scroll = 3.0f;
    input.next_frame();
    EXPECT_TRUE(input.down(Key::a));
    EXPECT_FALSE(input.pressed(Key::a));
    EXPECT_FALSE(input.pressed(MouseButton::left));
    EXPECT_EQ(input.mouse_delta, vec2(0.0f));
    EXPECT_EQ(input.scroll, 0.0f);
}

TEST(Input, OppositeKeysCancel) {
    Input input;
    press(input, Key::a);
    press(input, Key::d);
    EXPECT_EQ(input.axis(Key::d, Key::a), 0.0f);
}

TEST(Input, WhatBelongsToAWidgetIsForgotten) {
    Input input;
    press(input, Key::a);
    input.next_frame();
    input.ignore_keys();
    EXPECT_FALSE(input.active(Key::a));
    input.buttons_pressed.set(1);
    input.ignore_mouse();
    EXPECT_FALSE(input.pressed(MouseButton::right));
}

}  // namespace
}  // namespace sl
