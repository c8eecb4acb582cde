// SPDX-License-Identifier: MIT
#include "editor/editor_panel.h"

#include <imgui.h>

namespace sl {

void editor_panel(App& app, Renderer& renderer, EditorState& state) {
    if (!state.open) return;
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const float width = std::min(400.0f * state.scale, screen.WorkSize.x * 0.6f);
    const ImVec2 corner(screen.WorkPos.x + screen.WorkSize.x - width, screen.WorkPos.y);
    ImGui::SetNextWindowPos(corner, ImGuiCond_Appearing);
    ImGui::SetNextWindowSize(ImVec2(width, screen.WorkSize.y), ImGuiCond_Appearing);
    if (ImGui::Begin("Editor", &state.open)) {
        scene_sections(app, state);
        frame_sections(renderer, state);
    }
    ImGui::End();
}

}  // namespace sl
