// SPDX-License-Identifier: MIT
#include "game/settings/player_input.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "game/fly_camera.h"

namespace sl {
namespace {

Input holding(std::initializer_list<Key> keys) {
    Input input;
    for (const Key key : keys) {
        input.keys_down.set(static_cast<std::size_t>(key));
        input.keys_pressed.set(static_cast<std::size_t>(key));
    }
    return input;
}

Input with_pad(std::initializer_list<GamepadButton> buttons) {
    Input input;
    input.gamepad.connected = true;
    for (const GamepadButton button : buttons) {
        input.gamepad.buttons_down.set(static_cast<std::size_t>(button));
        input.gamepad.buttons_pressed.set(static_cast<std::size_t>(button));
    }
    return input;
}

TEST(KeyBindings, UsualKeysChangeNothing) {
    for (std::size_t i = 0; i < key_count; ++i) {
        const Input input = holding({static_cast<Key>(i)});
        EXPECT_EQ(with_usual_keys(input, {}).keys_down, input.keys_down) << i;
    }
}

TEST(KeyBindings, AnActionIsWhereItWasPutAndNowhereElse) {
    KeyBindings keys;
    keys[Action::forward] = Key::up;
    const Input moved = with_usual_keys(holding({Key::up}), keys);
    EXPECT_TRUE(moved.down(Key::w) && moved.pressed(Key::w));
    EXPECT_FALSE(moved.down(Key::up)) << "the sun stays where it is";
    EXPECT_FALSE(with_usual_keys(holding({Key::w}), keys).keys_down.any()) << "the old key does nothing";
    EXPECT_TRUE(with_usual_keys(holding({Key::digit_3}), keys).down(Key::digit_3));
}

TEST(KeyBindings, TwoActionsCanChangePlaces) {
    KeyBindings keys;
    std::swap(keys[Action::jump], keys[Action::crouch]);
    const Input jumping = with_usual_keys(holding({Key::c}), keys);
    EXPECT_TRUE(jumping.down(Key::space));
    EXPECT_FALSE(jumping.down(Key::c));
}

TEST(KeyBindings, ControlCanBeAKeyLikeAnyOther) {
    KeyBindings keys;
    keys[Action::crouch] = Key::control;
    const Input crouching = with_usual_keys(holding({Key::control, Key::w}), keys);
    EXPECT_TRUE(crouching.down(Key::c) && crouching.down(Key::w));
    EXPECT_FALSE(crouching.active(Key::control));
}

TEST(KeyBindings, ConflictsAreToldFromBothSidesAndBothActionsHappen) {
    KeyBindings keys;
    EXPECT_THAT(conflicts(keys, Action::jump), testing::IsEmpty());
    keys[Action::jump] = Key::f;
    EXPECT_THAT(conflicts(keys, Action::jump), testing::ElementsAre(Action::flashlight));
    EXPECT_THAT(conflicts(keys, Action::flashlight), testing::ElementsAre(Action::jump));
    const Input both = with_usual_keys(holding({Key::f}), keys);
    EXPECT_TRUE(both.down(Key::space) && both.down(Key::f));
}

TEST(KeyBindings, UsualKeysHaveNoConflicts) {
    for (std::size_t i = 0; i < action_count; ++i) EXPECT_THAT(conflicts({}, static_cast<Action>(i)), testing::IsEmpty()) << actions[i].name;
}

TEST(PlayerInput, TheMouseIsAsQuickAsItIsWanted) {
    Input input;
    input.mouse_delta = {10, 4};
    EXPECT_EQ(player_input(input, {}, 0.01).mouse_delta, vec2(10, 4));
    UserSettings settings;
    settings.controls = {.mouse_sensitivity = 0.5f, .invert_y = true};
    EXPECT_EQ(player_input(input, settings, 0.01).mouse_delta, vec2(5, -2));
}

TEST(PlayerInput, AGamepadPressesWhatItsButtonsStandFor) {
    const Input jump = player_input(with_pad({GamepadButton::a}), {}, 0.01);
    EXPECT_TRUE(jump.pressed(Key::space) && jump.down(Key::space));
    EXPECT_TRUE(player_input(with_pad({GamepadButton::b}), {}, 0.01).down(Key::c));
    EXPECT_TRUE(player_input(with_pad({GamepadButton::y}), {}, 0.01).pressed(Key::f));
    EXPECT_TRUE(player_input(with_pad({GamepadButton::x}), {}, 0.01).pressed(MouseButton::middle));
    EXPECT_TRUE(player_input(with_pad({GamepadButton::right_trigger}), {}, 0.01).pressed(MouseButton::left));
    EXPECT_TRUE(player_input(with_pad({GamepadButton::left_trigger}), {}, 0.01).pressed(MouseButton::right));
    EXPECT_EQ(player_input(with_pad({GamepadButton::right_bumper}), {}, 0.01).scroll, -1.0f) << "the next block";
    EXPECT_TRUE(player_input(with_pad({}), {}, 0.01).mouse_captured) << "a stick aims";
    EXPECT_FALSE(player_input({}, {}, 0.01).mouse_captured);
}

TEST(PlayerInput, AGamepadDoesTheSameWhereverTheKeysAre) {
    UserSettings settings;
    settings.keys[Action::jump] = Key::enter;
    EXPECT_TRUE(player_input(with_pad({GamepadButton::a}), settings, 0.01).down(Key::space));
}

TEST(PlayerInput, SticksWalkAndTurnByTime) {
    Input input = with_pad({});
    input.gamepad.left_stick = {0.05f, 0.08f};
    input.gamepad.right_stick = {0.1f, 0.0f};
    EXPECT_EQ(player_input(input, {}, 0.01).stick, vec2(0.0f)) << "at rest";
    EXPECT_EQ(player_input(input, {}, 0.01).mouse_delta, vec2(0.0f));
    input.gamepad.left_stick = {0.0f, 1.0f};
    input.gamepad.right_stick = {1.0f, 0.0f};
    const Input full = player_input(input, {}, 0.01);
    EXPECT_NEAR(full.stick.y, 1.0f, 1e-6f);
    EXPECT_GT(full.mouse_delta.x, 0.0f);
    EXPECT_NEAR(player_input(input, {}, 0.02).mouse_delta.x, 2.0f * full.mouse_delta.x, 1e-3f);
    input.gamepad.right_stick = {0.5f, 0.0f};
    EXPECT_LT(player_input(input, {}, 0.01).mouse_delta.x, 0.25f * full.mouse_delta.x) << "finer than half as quick";
    input.gamepad.right_stick = {0.0f, 1.0f};
    EXPECT_LT(player_input(input, {}, 0.01).mouse_delta.y, 0.0f) << "forward looks up";
}

TEST(PlayerInput, AHalfPushedStickFliesHalfAsFast) {
    App app;
    app.world.add_resource(FrameClock{.step = 1.0});
    const Entity camera = app.world.create(Camera{}, Transform{});
    add_fly_camera(app);
    app.world.resource<Input>().stick = {0.0f, 0.5f};
    app.schedule.run(app.world);
    EXPECT_NEAR(app.world.get<Transform>(camera).translation.z, -0.5 * FlyCamera{}.speed, 1e-4);
}

}  // namespace
}  // namespace sl
