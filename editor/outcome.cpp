// SPDX-License-Identifier: MIT
#include "editor/outcome.h"

#include <imgui.h>

namespace sl {

void warning_text(const char* text) {
    ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(255, 150, 90, 255));
    ImGui::TextWrapped("%s", text);
    ImGui::PopStyleColor();
}

void show(const Outcome& outcome) {
    if (outcome.text.empty()) return;
    if (outcome.failed) {
        warning_text(outcome.text.c_str());
    } else {
        ImGui::TextWrapped("%s", outcome.text.c_str());
    }
}

}  // namespace sl
