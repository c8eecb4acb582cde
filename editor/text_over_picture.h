// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

#include <string>

namespace sl {

/// A line of text with a dark ground, behind all widgets. `corner`: the text's upper left.
inline void text_over_picture(const std::string& text, ImVec2 corner) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const float gap = ImGui::GetFontSize() * 0.4f;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(ImVec2(corner.x - gap, corner.y - gap), ImVec2(corner.x + size.x + gap, corner.y + size.y + gap), IM_COL32(0, 0, 0, 150), gap);
    list.AddText(corner, IM_COL32_WHITE, text.c_str());
}

}  // namespace sl
