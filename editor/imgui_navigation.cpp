// SPDX-License-Identifier: MIT
#include "editor/imgui_navigation.h"

#include <imgui_internal.h>

namespace sl {

namespace {

/// How far a stick is moved where it means a direction.
constexpr float pushed = 0.5f;

void give(ImGuiNavInput_ to, bool held) {
    if (held) ImGui::GetIO().NavInputs[to] = 1.0f;
}

void gamepad(const Gamepad& pad) {
    give(ImGuiNavInput_Activate, pad.down(GamepadButton::a));
    give(ImGuiNavInput_Cancel, pad.down(GamepadButton::b));
    give(ImGuiNavInput_DpadUp, pad.down(GamepadButton::up) || pad.left_stick.y > pushed);
    give(ImGuiNavInput_DpadDown, pad.down(GamepadButton::down) || pad.left_stick.y < -pushed);
    give(ImGuiNavInput_DpadLeft, pad.down(GamepadButton::left) || pad.left_stick.x < -pushed);
    give(ImGuiNavInput_DpadRight, pad.down(GamepadButton::right) || pad.left_stick.x > pushed);
}

/// Whoever leaves the mouse alone sees which widget a press would mean; ImGui shows it only once it was moved, and until then
/// presses nothing.
void show_focus(const Input& input) {
    bool steered = input.gamepad.buttons_pressed.any();
    for (const Key key : {Key::escape, Key::enter, Key::space, Key::tab, Key::up, Key::down, Key::left, Key::right}) steered |= input.pressed(key);
    if (steered) ImGui::GetCurrentContext()->NavDisableHighlight = false;
}

}  // namespace

void navigate_widgets(bool on, const Input& input) {
    ImGuiIO& io = ImGui::GetIO();
    if (!on) {
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
        return;
    }
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    // ImGui's own Enter edits a value as text and presses no button.
    give(ImGuiNavInput_Activate, input.pressed(Key::enter) && !io.WantTextInput);
    gamepad(input.gamepad);
    show_focus(input);
}

}  // namespace sl
