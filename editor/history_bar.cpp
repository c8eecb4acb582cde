// SPDX-License-Identifier: MIT
#include "editor/history_bar.h"

#include <imgui.h>

namespace sl {

namespace {

bool control_and(ImGuiKey key, bool shift) {
    const ImGuiIO& io = ImGui::GetIO();
    return io.KeyCtrl && io.KeyShift == shift && ImGui::IsKeyPressed(ImGui::GetKeyIndex(key));
}

bool step_button(const char* verb, const std::string& step, const char* keys, float width) {
    const std::string text = step.empty() ? fmt::format("{}###{}", verb, verb) : fmt::format("{} {}###{}", verb, step, verb);
    ImGui::BeginDisabled(step.empty());
    const bool pressed = ImGui::Button(text.c_str(), ImVec2(width, 0.0f));
    ImGui::EndDisabled();
    if (!step.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s %s (%s)", verb, step.c_str(), keys);
    return pressed;
}

}  // namespace

void history_bar(const EditedScene& scene) {
    EditHistory& history = scene.history;
    if (!ImGui::IsAnyItemActive()) history.end_gesture();
    const std::string undo = history.done().empty() ? "" : history.done().back().label;
    const std::string redo = history.undone().empty() ? "" : history.undone().front().label;
    // A name that is typed, or a slider that is held, has an undo of its own, or none yet.
    const bool free = !ImGui::IsAnyItemActive();
    const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    const bool undo_wanted = step_button("Undo", undo, "Ctrl+Z", width) || (free && control_and(ImGuiKey_Z, false));
    ImGui::SameLine();
    const bool redo_wanted = step_button("Redo", redo, "Ctrl+Y", width) ||
                             (free && (control_and(ImGuiKey_Y, false) || control_and(ImGuiKey_Z, true)));
    if (undo_wanted) {
        history.undo(scene.world, scene.registry);
    } else if (redo_wanted) {
        history.redo(scene.world, scene.registry);
    }
}

}  // namespace sl
