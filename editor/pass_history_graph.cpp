// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "editor/pass_history.h"

namespace sl {

namespace {

/// Told apart also by those who see few colours: Okabe and Ito's, for a dark ground.
constexpr std::array<ImU32, 7> colours{IM_COL32(230, 159, 0, 255), IM_COL32(86, 180, 233, 255), IM_COL32(0, 158, 115, 255),
                                       IM_COL32(240, 228, 66, 255), IM_COL32(0, 114, 178, 255), IM_COL32(213, 94, 0, 255),
                                       IM_COL32(204, 121, 167, 255)};
constexpr float height_in_lines = 6.0f;

ImU32 colour_of(std::size_t pass) {
    return colours[pass % colours.size()];
}

/// Where the graph lies on the screen, and what its height means.
struct Plot {
    ImVec2 low, high;
    float most;  ///< ms

    float column() const { return (high.x - low.x) / static_cast<float>(PassHistory::longest); }
    float x(const PassHistory& history, std::size_t frame) const {
        return high.x - column() * static_cast<float>(history.frames() - frame);
    }
    float y(float milliseconds) const { return high.y - (high.y - low.y) * milliseconds / most; }
};

/// 1, 2 or 5 times a power of ten, so that the scale stands still while times change a little.
float round_up(float value) {
    const float power = std::pow(10.0f, std::floor(std::log10(std::max(value, 0.01f))));
    for (const float factor : {1.0f, 2.0f, 5.0f}) {
        if (value <= factor * power) return factor * power;
    }
    return 10.0f * power;
}

void draw_areas(const PassHistory& history, const Plot& plot) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(plot.low, plot.high, ImGui::GetColorU32(ImGuiCol_FrameBg));
    for (std::size_t frame = 0; frame < history.frames(); ++frame) {
        const float left = plot.x(history, frame);
        float below = 0.0f;
        for (std::size_t pass = 0; pass < history.passes().size(); ++pass) {
            const float above = below + history.milliseconds(frame, pass);
            list.AddRectFilled(ImVec2(left, plot.y(above)), ImVec2(left + plot.column(), plot.y(below)), colour_of(pass));
            below = above;
        }
    }
    char scale[32];
    std::snprintf(scale, sizeof scale, "%g ms", static_cast<double>(plot.most));
    list.AddText(ImVec2(plot.low.x + 3.0f, plot.low.y + 1.0f), ImGui::GetColorU32(ImGuiCol_TextDisabled), scale);
}

void explain_frame(const PassHistory& history, std::size_t frame) {
    ImGui::BeginTooltip();
    ImGui::Text("%zu frames ago: %.3f ms", history.frames() - 1 - frame, static_cast<double>(history.sum(frame)));
    for (std::size_t pass = history.passes().size(); pass-- > 0;) {
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour_of(pass)), "%7.3f  %s",
                           static_cast<double>(history.milliseconds(frame, pass)), history.passes()[pass].c_str());
    }
    ImGui::EndTooltip();
}

/// Names in their colours, as many to a line as fit.
void draw_legend(const PassHistory& history) {
    const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
    for (std::size_t pass = 0; pass < history.passes().size(); ++pass) {
        const std::string& name = history.passes()[pass];
        const float end = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + ImGui::CalcTextSize(name.c_str()).x;
        if (pass > 0 && end < right) ImGui::SameLine();
        ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour_of(pass)), "%s", name.c_str());
    }
}

}  // namespace

void draw_pass_history(const PassHistory& history) {
    const ImVec2 size(std::max(ImGui::GetContentRegionAvail().x, 1.0f), height_in_lines * ImGui::GetTextLineHeight());
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const Plot plot{low, ImVec2(low.x + size.x, low.y + size.y), round_up(history.largest_sum())};
    ImGui::InvisibleButton("history", size);
    draw_areas(history, plot);
    if (ImGui::IsItemHovered()) {
        const float from_right = (plot.high.x - ImGui::GetIO().MousePos.x) / plot.column();
        const auto back = static_cast<std::size_t>(std::max(from_right, 0.0f));
        if (back < history.frames()) explain_frame(history, history.frames() - 1 - back);
    }
    draw_legend(history);
}

}  // namespace sl
