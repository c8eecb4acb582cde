// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <algorithm>

#include "editor/editor_panel.h"
#include "engine/render/pass_times.h"

namespace sl {

namespace {

constexpr double smoothing = 0.1;  // share of the newest frame

std::vector<gl::SpanTime> smoothed_times(Renderer& renderer, EditorState& state) {
    std::vector<gl::SpanTime> rows = pass_times(renderer.executor().timers().newest());
    for (gl::SpanTime& row : rows) {
        double& mean = state.smoothed_passes.try_emplace(row.name, row.milliseconds).first->second;
        mean += smoothing * (row.milliseconds - mean);
        row.milliseconds = mean;
    }
    return rows;
}

void pass_table(Renderer& renderer, EditorState& state) {
    const std::vector<gl::SpanTime> rows = smoothed_times(renderer, state);
    double sum = 0.0, longest = 1e-6;
    for (const gl::SpanTime& row : rows) {
        sum += row.milliseconds;
        longest = std::max(longest, row.milliseconds);
    }
    ImGui::Text("%.2f ms in %zu passes, of which GI %.2f ms", sum, rows.size(), gi_milliseconds(rows));
    if (!ImGui::BeginTable("passes", 3, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("pass", ImGuiTableColumnFlags_WidthStretch, 0.45f);
    ImGui::TableSetupColumn("ms", ImGuiTableColumnFlags_WidthStretch, 0.2f);
    ImGui::TableSetupColumn("share", ImGuiTableColumnFlags_WidthStretch, 0.35f);
    for (const gl::SpanTime& row : rows) {
        ImGui::TableNextRow();
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row.name.c_str());
        ImGui::TableNextColumn();
        ImGui::Text("%.3f", row.milliseconds);
        ImGui::TableNextColumn();
        ImGui::ProgressBar(static_cast<float>(row.milliseconds / longest),
                           ImVec2(-1.0f, ImGui::GetTextLineHeight()), "");
    }
    ImGui::EndTable();
}

void frame_table(const Renderer& renderer) {
    const std::string table = renderer.graph().table(renderer.steps());
    const float height =
        ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(renderer.steps().size() + 3);
    ImGui::BeginChild("table", ImVec2(0.0f, height), true, ImGuiWindowFlags_HorizontalScrollbar);
    ImGui::TextUnformatted(table.c_str(), table.c_str() + table.size());
    ImGui::EndChild();
}

}  // namespace

void frame_sections(Renderer& renderer, EditorState& state) {
    if (ImGui::CollapsingHeader("GPU time per pass", ImGuiTreeNodeFlags_DefaultOpen))
        pass_table(renderer, state);
    if (ImGui::CollapsingHeader("Frame graph")) frame_table(renderer);
}

}  // namespace sl
