// SPDX-License-Identifier: MIT
#include "editor/frame_tab.h"

#include <imgui.h>

#include <algorithm>

#include "engine/render/pass_times.h"

namespace sl {

namespace {

struct TimeRow {
    std::string name;
    double milliseconds;
};

/// Names, times, and a bar for each in units of the longest.
void time_table(const char* id, const std::vector<TimeRow>& rows) {
    double longest = 1e-6;
    for (const TimeRow& row : rows) longest = std::max(longest, row.milliseconds);
    if (!ImGui::BeginTable(id, 3, ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_RowBg)) return;
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, 0.55f);
    ImGui::TableSetupColumn("ms", ImGuiTableColumnFlags_WidthStretch, 0.15f);
    ImGui::TableSetupColumn("share", ImGuiTableColumnFlags_WidthStretch, 0.3f);
    for (const TimeRow& row : rows) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(row.name.c_str());
        ImGui::TableNextColumn();
        ImGui::Text("%.3f", row.milliseconds);
        ImGui::TableNextColumn();
        ImGui::ProgressBar(static_cast<float>(row.milliseconds / longest), ImVec2(-1.0f, ImGui::GetTextLineHeight()), "");
    }
    ImGui::EndTable();
}

void pass_times_section(const FrameReport& report, SmoothedTimes& smoothed) {
    if (!ImGui::CollapsingHeader("GPU time per pass", ImGuiTreeNodeFlags_DefaultOpen)) return;
    std::vector<TimeRow> rows;
    double sum = 0.0;
    for (const gl::SpanTime& time : report.times) {
        rows.push_back({time.name, smoothed.follow(time.name, time.milliseconds)});
        sum += rows.back().milliseconds;
    }
    ImGui::Text("%.2f ms in %zu passes, of which GI %.2f ms", sum, rows.size(), gi_milliseconds(report.times));
    time_table("passes", rows);
}

void systems_section(const Schedule& schedule, SmoothedTimes& smoothed) {
    if (!ImGui::CollapsingHeader("Systems")) return;
    std::vector<TimeRow> rows;
    for (const SystemTiming& timing : schedule.timings()) {
        const std::string name(timing.name);
        const std::string_view stage = stage_names[static_cast<std::size_t>(timing.stage)];
        rows.push_back({fmt::format("{}: {}", stage, name), smoothed.follow(name, 1e3 * timing.seconds)});
    }
    time_table("systems", rows);
}

void cell(const std::string& text) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
}

void graph_section(const FrameReport& report, SmoothedTimes& smoothed) {
    if (!ImGui::CollapsingHeader("Frame graph")) return;
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_ScrollX |
                                      ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_Resizable;
    const float lines = static_cast<float>(std::min<std::size_t>(report.passes.size(), 14) + 2);
    if (!ImGui::BeginTable("graph", 6, flags, ImVec2(0.0f, lines * ImGui::GetTextLineHeightWithSpacing()))) return;
    for (const char* heading : {"pass", "ms", "draws", "triangles", "writes", "reads"}) ImGui::TableSetupColumn(heading);
    ImGui::TableSetupScrollFreeze(1, 1);
    ImGui::TableHeadersRow();
    for (const PassReport& pass : report.passes) {
        cell(pass.name);
        cell(pass.milliseconds ? fmt::format("{:.3f}", smoothed.follow(pass.name, *pass.milliseconds)) : "-");
        cell(pass.draws > 0 ? fmt::format("{}", pass.draws) : "");
        cell(pass.draws > 0 ? fmt::format("{}", pass.triangles) : "");
        cell(pass.writes);
        cell(pass.reads);
    }
    ImGui::EndTable();
}

void figure(const char* name, const std::string& value) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    cell(value);
}

void figures_section(const FrameReport& report) {
    if (!ImGui::CollapsingHeader("Triangles and memory", ImGuiTreeNodeFlags_DefaultOpen)) return;
    std::size_t draws = 0;
    for (const PassReport& pass : report.passes) draws += pass.draws;
    const auto mebibytes = [](std::uint64_t bytes) { return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / 1048576.0); };
    if (!ImGui::BeginTable("figures", 2, ImGuiTableFlags_SizingStretchProp)) return;
    figure("picture", fmt::format("{} x {} pixels", report.size.x, report.size.y));
    figure("draws in all passes", fmt::format("{}", draws));
    figure("triangles seen", fmt::format("{}", report.triangles_drawn));
    figure("triangles culled", fmt::format("{}", report.triangles_culled));
    figure("buffers of meshes", mebibytes(report.mesh_bytes));
    figure("textures", mebibytes(report.texture_bytes));
    figure("lights without room for shadows", fmt::format("{}", report.lights_without_maps));
    ImGui::EndTable();
}

}  // namespace

void frame_tab(const FrameReport& report, const Schedule& schedule, FrameTab& state) {
    pass_times_section(report, state.kinds);
    figures_section(report);
    systems_section(schedule, state.systems);
    graph_section(report, state.passes);
}

}  // namespace sl
