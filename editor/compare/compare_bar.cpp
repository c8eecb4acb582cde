// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <algorithm>

#include "editor/compare/compare_view.h"
#include "editor/text_over_picture.h"

namespace sl {

namespace {

constexpr ImU32 line = IM_COL32(255, 255, 255, 200), edge = IM_COL32(0, 0, 0, 140);

/// Beside the bar: its right edge (or its left one) at `x`.
void label(const std::string& text, float x, bool left_of, float y) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float gap = ImGui::GetFontSize() * 0.4f, from = left_of ? x - size.x - 2.0f * gap : x + 2.0f * gap;
    text_over_picture(text, ImVec2(from, y));
}

}  // namespace

void draw_compare_bar(CompareView& view, float scale) {
    if (!view.on || view.blink) return;
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const float x = screen.Pos.x + view.split * screen.Size.x, half = 8.0f * scale;
    // A window as wide as a finger: what is dragged there is no click into the game.
    ImGui::SetNextWindowPos(ImVec2(x - half, screen.Pos.y));
    ImGui::SetNextWindowSize(ImVec2(2.0f * half, screen.Size.y));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    ImGui::Begin("compare bar", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav);
    ImGui::InvisibleButton("grip", ImVec2(2.0f * half, screen.Size.y));
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive()) view.split = std::clamp((ImGui::GetIO().MousePos.x - screen.Pos.x) / screen.Size.x, 0.0f, 1.0f);
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddLine(ImVec2(x, screen.Pos.y), ImVec2(x, screen.Pos.y + screen.Size.y), edge, 4.0f * scale);
    list.AddLine(ImVec2(x, screen.Pos.y), ImVec2(x, screen.Pos.y + screen.Size.y), line, 2.0f * scale);
    const float y = screen.Pos.y + screen.Size.y * 0.5f + 2.0f * ImGui::GetFontSize();
    label(compare_source_name(view.left.source), x, true, y);
    label(compare_source_name(view.right.source), x, false, y);
}

}  // namespace sl
