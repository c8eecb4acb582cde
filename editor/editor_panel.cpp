// SPDX-License-Identifier: MIT
#include "editor/editor_panel.h"

#include <imgui.h>

#include <algorithm>

#include "editor/history_bar.h"
#include "editor/light_gizmos.h"

namespace sl {

namespace {

constexpr float usual_width = 400.0f, widest_share = 0.6f;

void place_window(float scale) {
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const float width = std::min(usual_width * scale, screen.WorkSize.x * widest_share);
    ImGui::SetNextWindowPos(ImVec2(screen.WorkPos.x + screen.WorkSize.x - width, screen.WorkPos.y), ImGuiCond_Appearing);
    ImGui::SetNextWindowSize(ImVec2(width, screen.WorkSize.y), ImGuiCond_Appearing);
}

/// A tab whose content scrolls by itself, so that undo and the other tabs stay in sight.
template <class F>
void tab(const char* name, F content) {
    if (!ImGui::BeginTabItem(name)) return;
    ImGui::BeginChild(name, ImVec2(0.0f, 0.0f), false, ImGuiWindowFlags_NavFlattened);
    content();
    ImGui::EndChild();
    ImGui::EndTabItem();
}

void tabs(App& app, const EditedScene& scene, const FrameReport& report, EditorState& state) {
    if (!ImGui::BeginTabBar("tabs")) return;
    tab("Light", [&] { light_tab(scene, report, state.light); });
    tab("Scene", [&] { scene_tab(scene, state.scene); });
    tab("Compare", [&] { compare_tab(state.compare); });
    tab("See", [&] { see_tab(app.world, state.see); });
    tab("Picture", [&] { picture_tab(scene, report, state.picture); });
    tab("Frame", [&] { frame_tab(report, app.schedule, state.frame); });
    ImGui::EndTabBar();
}

}  // namespace

void editor_panel(App& app, const FrameReport& report, EditorState& state) {
    if (!state.open) return;
    const EditedScene scene{app.world, app.registry(), state.history};
    place_window(state.scale);
    state.see.picks = false;
    if (ImGui::Begin("Editor", &state.open)) {
        history_bar(scene);
        tabs(app, scene, report, state);
    }
    ImGui::End();
    if (const Entity chosen = selected_entity(scene, state.scene)) draw_light_gizmos(app.world, chosen, state.scale);
}

bool click_picture(EditorState& state) {
    if (!state.open || !state.see.picks) return false;
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    state.see.probe.pick({(mouse.x - screen.Pos.x) / screen.Size.x, (mouse.y - screen.Pos.y) / screen.Size.y});
    return true;
}

}  // namespace sl
