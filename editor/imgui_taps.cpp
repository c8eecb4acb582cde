// SPDX-License-Identifier: MIT
#include "editor/imgui_taps.h"

#include <imgui.h>

namespace sl {

void keep_taps(const Input& input) {
    constexpr std::pair<ImGuiKey, Key> keys[] = {
        {ImGuiKey_Tab, Key::tab},       {ImGuiKey_LeftArrow, Key::left}, {ImGuiKey_RightArrow, Key::right},   {ImGuiKey_UpArrow, Key::up},
        {ImGuiKey_DownArrow, Key::down}, {ImGuiKey_PageUp, Key::page_up}, {ImGuiKey_PageDown, Key::page_down}, {ImGuiKey_Home, Key::home},
        {ImGuiKey_End, Key::end},       {ImGuiKey_Insert, Key::insert},  {ImGuiKey_Backspace, Key::backspace}, {ImGuiKey_Space, Key::space},
        {ImGuiKey_Enter, Key::enter},   {ImGuiKey_Escape, Key::escape},  {ImGuiKey_A, Key::a},                 {ImGuiKey_C, Key::c},
        {ImGuiKey_V, Key::v},           {ImGuiKey_X, Key::x},            {ImGuiKey_Y, Key::y},                 {ImGuiKey_Z, Key::z}};
    ImGuiIO& io = ImGui::GetIO();
    io.KeyCtrl = input.active(Key::control);
    io.KeyShift = input.active(Key::shift);
    for (const auto& [to, from] : keys) {
        if (io.KeyMap[to] >= 0) io.KeysDown[io.KeyMap[to]] = input.down(from) || input.pressed(from);
    }
}

}  // namespace sl
