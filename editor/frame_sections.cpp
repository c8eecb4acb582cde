// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <algorithm>

#include "editor/editor_panel.h"

namespace sl {

namespace {

constexpr double smoothing = 0.1;  // share of the newest frame

/// Passes of one name (a light's layers) add up; slices of a sum are one row, so that rows do not come and
/// go.
std::string row_of(const std::string& pass) {
    const std::size_t end = pass.find_last_not_of("0123456789");
    const bool numbered = end != std::string::npos && end + 1 < pass.size() && pass[end] == '_';
    return numbered ? pass.substr(0, end) : pass;
}

struct PassTime {
    std::string name;
    double milliseconds;
};

std::vector<PassTime> smoothed_times(Renderer& renderer, EditorState& state) {
    std::vector<PassTime> rows;
    for (const auto& [pass, milliseconds] : renderer.executor().timers().newest()) {
        const std::string name = row_of(pass);
        const auto row = std::ranges::find(rows, name, &PassTime::name);
        if (row == rows.end()) {
            rows.push_back({name, milliseconds});
        } else {
            row->milliseconds += milliseconds;
        }
    }
    for (PassTime& row : rows) {
        double& mean = state.smoothed_passes.try_emplace(row.name, row.milliseconds).first->second;
        mean += smoothing * (row.milliseconds - mean);
        row.milliseconds = mean;
    }
    return rows;
}

void pass_times(Renderer& renderer, EditorState& state) {
    const std::vector<PassTime> rows = smoothed_times(renderer, state);
    double sum = 0.0, longest = 1e-6;
    for (const PassTime& row : rows) {
        sum += row.milliseconds;
        longest = std::max(longest, row.milliseconds);
    }
    ImGui::Text("%.2f ms in %zu passes", sum, rows.size());
    if (!ImGui::BeginTable("passes", 3, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("pass", ImGuiTableColumnFlags_WidthStretch, 0.45f);
    ImGui::TableSetupColumn("ms", ImGuiTableColumnFlags_WidthStretch, 0.2f);
    ImGui::TableSetupColumn("share", ImGuiTableColumnFlags_WidthStretch, 0.35f);
    for (const PassTime& row : rows) {
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
        pass_times(renderer, state);
    if (ImGui::CollapsingHeader("Frame graph")) frame_table(renderer);
}

}  // namespace sl
