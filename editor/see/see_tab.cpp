// SPDX-License-Identifier: MIT
#include <imgui.h>

#include "editor/outcome.h"
#include "editor/see/probe_table.h"
#include "editor/see/see_view.h"

namespace sl {

namespace {

constexpr float most_stops = 12.0f;

std::string label(const ListedImage& image) {
    return image.layers > 1 ? fmt::format("{}  {} x {}, {} layers", image.name, image.size.x, image.size.y, image.layers) : fmt::format("{}  {} x {}", image.name, image.size.x, image.size.y);
}

void choose_image(ShownImage& shown) {
    const std::string now = shown.name.empty() ? "nothing" : shown.name;
    if (!ImGui::BeginCombo("image", now.c_str(), ImGuiComboFlags_HeightLarge)) return;
    if (ImGui::Selectable("nothing", shown.name.empty())) shown.name.clear();
    for (const ListedImage& image : shown.listed()) {
        if (ImGui::Selectable(label(image).c_str(), image.name == shown.name)) shown.name = image.name;
    }
    ImGui::EndCombo();
}

void choose_layer(ShownImage& shown, std::uint32_t layers) {
    int layer = static_cast<int>(shown.layer);
    if (ImGui::SliderInt("layer", &layer, 0, static_cast<int>(layers) - 1, "%d", ImGuiSliderFlags_AlwaysClamp)) shown.layer = static_cast<std::uint32_t>(layer);
}

void image_section(ShownImage& shown) {
    choose_image(shown);
    if (shown.name.empty()) return ImGui::TextWrapped("Shows an image that the frame makes instead of the picture.");
    if (const ListedImage* image = shown.chosen(); image != nullptr && image->layers > 1) choose_layer(shown, image->layers);
    ImGui::BeginDisabled(!shown.has_exposure());
    ImGui::SliderFloat("brighter", &shown.stops, -most_stops, most_stops, "%+.1f stops", ImGuiSliderFlags_AlwaysClamp);
    ImGui::EndDisabled();
    if (ImGui::Button("Back to the picture")) shown.name.clear();
    if (!shown.range().empty()) {
        ImGui::TextWrapped("black to white: %s", shown.range().c_str());
    } else if (shown.chosen() != nullptr) {
        ImGui::TextWrapped("This frame did not have to draw it anew.");
    } else if (!shown.name.empty()) {
        warning_text(fmt::format("This frame has no image {}.", shown.name).c_str());
    }
}

void facets_section(FacetOutlines& facets) {
    ImGui::Checkbox("outlines of facets", &facets.on);
    if (!facets.on) return;
    ImGui::SameLine();
    if (ImGui::RadioButton("irradiance", facets.colour == FacetOutlines::Colour::irradiance)) facets.colour = FacetOutlines::Colour::irradiance;
    ImGui::SameLine();
    if (ImGui::RadioButton("noise", facets.colour == FacetOutlines::Colour::noise)) facets.colour = FacetOutlines::Colour::noise;
    if (facets.size() == 0) return ImGui::TextWrapped("There are none: the method facets keeps light on them.");
    const bool noise = facets.colour == FacetOutlines::Colour::noise;
    const std::string top = noise ? fmt::format("{:.2g} %", 100.0f * facets.top()) : fmt::format("{:.3g} lux", facets.top());
    ImGui::TextWrapped("The nearest %zu; dark to bright: 0 to %s", facets.size(), top.c_str());
}

void probe_section(const World& world, PixelProbe& probe) {
    ImGui::TextWrapped("Click into the picture to measure the light there.");
    if (probe.missed()) ImGui::TextUnformatted("There is no surface.");
    if (!probe.reading()) return;
    probe_table(world, *probe.reading());
    if (ImGui::Button("Forget the point")) probe.forget();
}

}  // namespace

void see_tab(const World& world, SeeView& view) {
    view.picks = true;
    image_section(view.image);
    ImGui::Separator();
    facets_section(view.facets);
    ImGui::Separator();
    probe_section(world, view.probe);
}

}  // namespace sl
