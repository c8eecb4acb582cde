// SPDX-License-Identifier: MIT
#include "game/menu/menu_window.h"

#include <algorithm>

namespace sl {

namespace {

constexpr ImU32 alarming = IM_COL32(255, 150, 90, 255);

}  // namespace

MenuWindow::MenuWindow(const char* title, float width) {
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const float font = ImGui::GetFontSize();
    const ImVec2 most(std::max(screen.Size.x - font, 1.0f), std::max(screen.Size.y - font, 1.0f));
    const float fitting = std::min(width * font, most.x);
    ImGui::SetNextWindowPos(screen.GetCenter(), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(fitting, 0.0f), ImVec2(fitting, most.y));
    ImGui::Begin(title, nullptr, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
    if (ImGui::IsWindowAppearing()) ImGui::SetWindowFocus();
}

MenuWindow::~MenuWindow() { ImGui::End(); }

bool menu_button(const char* label) {
    const bool first = ImGui::IsWindowAppearing() && ImGui::GetCursorPosY() <= ImGui::GetCursorStartPos().y;
    const bool pressed = ImGui::Button(label, ImVec2(-std::numeric_limits<float>::min(), ImGui::GetFrameHeight() * 1.35f));
    if (first) ImGui::SetItemDefaultFocus();
    return pressed;
}

void menu_text(const std::string& text) {
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopTextWrapPos();
}

void menu_problem(const std::string& text) {
    if (text.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, alarming);
    menu_text(text);
    ImGui::PopStyleColor();
}

void menu_heading(const char* text) {
    ImGui::Spacing();
    ImGui::TextDisabled("%s", text);
    ImGui::Separator();
}

}  // namespace sl
