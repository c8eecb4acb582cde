// SPDX-License-Identifier: MIT
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "editor/compare/compare_view.h"
#include "engine/measure/heat_map.h"

namespace sl {

namespace {

void choose_source(const char* label, CompareSource& source) {
    if (!ImGui::BeginCombo(label, compare_source_name(source).c_str())) return;
    for (std::size_t i = 0; i < compare_source_count(); ++i) {
        const auto choice = static_cast<CompareSource>(i);
        if (ImGui::Selectable(compare_source_name(choice).c_str(), choice == source)) source = choice;
    }
    ImGui::EndCombo();
}

std::string duration(double seconds) {
    if (seconds < 90.0) return fmt::format("{:.0f} s", seconds);
    return seconds < 5400.0 ? fmt::format("{:.0f} min", seconds / 60.0) : fmt::format("{:.1f} h", seconds / 3600.0);
}

void reference_progress(const LiveReference& reference) {
    const auto picture = reference.picture();
    if (picture == nullptr) return ImGui::TextUnformatted("The reference begins once nothing moves.");
    const double left = picture->share > 0.0 ? picture->seconds * (1.0 / picture->share - 1.0) : 0.0;
    const std::string text = picture->share < 1.0 ? fmt::format("{} samples a pixel, about {} left", picture->samples, duration(left)) : fmt::format("done: {} samples a pixel", picture->samples);
    ImGui::ProgressBar(static_cast<float>(picture->share), ImVec2(-1.0f, 0.0f), text.c_str());
}

void figure(const char* name, const std::string& value, const char* help) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(name);
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(value.c_str());
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", help);
}

void figures_table(const CompareFigures& figures) {
    if (!ImGui::BeginTable("figures", 3, ImGuiTableFlags_SizingFixedFit | ImGuiTableFlags_RowBg)) return;
    const double both = figures.irradiance.nrmse, noise = figures.truth_noise;
    figure("NRMSE", fmt::format("{:.1f} %", 100.0 * both), "of indirect light");
    // Errors of the two are independent, so that their squares add.
    figure("", both > noise ? fmt::format("{:.1f} %", 100.0 * std::sqrt(both * both - noise * noise)) : "hidden", "of that not by the reference's noise");
    figure("bias", fmt::format("{:+.1f} %", 100.0 * figures.irradiance.bias), "of indirect light");
    figure("FLIP", fmt::format("{:.3f}", figures.flip), "of the shown picture");
    figure("noise", fmt::format("{:.1f} %", 100.0 * figures.truth_noise), "of the reference itself");
    ImGui::EndTable();
}

void legend() {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x, height = ImGui::GetTextLineHeight();
    constexpr int steps = 64;
    for (int i = 0; i < steps; ++i) {
        const vec3 colour = heat_colour((static_cast<float>(i) + 0.5f) / steps);
        const float from = corner.x + width * static_cast<float>(i) / steps, to = corner.x + width * static_cast<float>(i + 1) / steps;
        ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(from, corner.y), ImVec2(to, corner.y + height), ImGui::ColorConvertFloat4ToU32(ImVec4(colour.x, colour.y, colour.z, 1.0f)));
    }
    ImGui::Dummy(ImVec2(width, height));
    ImGui::TextUnformatted("0 %");
    ImGui::SameLine(std::max(0.0f, width - ImGui::CalcTextSize("100 % off and more").x));
    ImGui::TextUnformatted("100 % off and more");
}

/// Of the screen's width: its middle, or the middle of what the panel leaves free beside it where it hides that.
float split_in_the_open() {
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const float low = (ImGui::GetWindowPos().x - screen.Pos.x) / screen.Size.x, high = low + ImGui::GetWindowWidth() / screen.Size.x;
    if (low > 0.5f || high < 0.5f) return 0.5f;
    return low > 1.0f - high ? 0.5f * std::max(low, 0.0f) : 0.5f * (1.0f + std::min(high, 1.0f));
}

}  // namespace

void compare_tab(CompareView& view) {
    if (ImGui::Checkbox("Compare", &view.on) && view.on) view.split = split_in_the_open();
    if (!view.on) return ImGui::TextWrapped("Shows two pictures of one view side by side, and how far the light of the live one is from the path-traced truth.");
    choose_source("left", view.left.source);
    choose_source("right", view.right.source);
    ImGui::SliderFloat("split", &view.split, 0.0f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
    ImGui::Checkbox("blink", &view.blink);
    ImGui::SameLine();
    if (ImGui::Button("Freeze the live picture")) view.freeze();
    ImGui::Separator();
    if (view.reference() != nullptr) reference_progress(*view.reference());
    if (const auto& figures = view.figures()) figures_table(*figures);
    if (view.left.source == CompareSource::error || view.right.source == CompareSource::error) legend();
    if (const std::string problem = view.problem(); !problem.empty()) ImGui::TextWrapped("%s", problem.c_str());
    ImGui::TextWrapped("Both sides have the live picture's exposure. A camera that adapts holds it once the reference has begun.");
}

}  // namespace sl
