// SPDX-License-Identifier: MIT
#include "game/app/hud_crystals.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "engine/ecs/components/name.h"
#include "engine/ecs/query.h"
#include "game/crystals/crystals.h"

namespace sl {

namespace {

constexpr ImU32 ground = IM_COL32(0, 0, 0, 140), text_colour = IM_COL32(255, 255, 255, 255), faint = IM_COL32(255, 255, 255, 150);
/// Farther off, a crystal's needs are not shown, m.
constexpr float shown_within = 8.0f;
constexpr int sparks = 90;

/// A colour of light at full brightness.
ImU32 hue(vec3 light) {
    const float brightest = std::max({light.x, light.y, light.z});
    if (!(brightest > 0.0f)) return IM_COL32(30, 30, 30, 255);
    const vec3 shown = glm::pow(glm::clamp(light / brightest, 0.0f, 1.0f), vec3(1.0f / 2.2f)) * 255.0f;
    return IM_COL32(static_cast<int>(shown.x), static_cast<int>(shown.y), static_cast<int>(shown.z), 255);
}

/// Text on a dark ground, its middle at `top`'s x; returns the lower edge.
float centred_text(ImVec2 top, const std::string& text, ImU32 colour) {
    const float gap = ImGui::GetFontSize() * 0.4f, widest = ImGui::GetMainViewport()->Size.x * 0.8f;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, widest);
    const ImVec2 corner(std::round(top.x - 0.5f * size.x), top.y);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(ImVec2(corner.x - gap, corner.y - gap * 0.5f), ImVec2(corner.x + size.x + gap, corner.y + size.y + gap * 0.5f), ground, gap);
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), corner, colour, text.c_str(), nullptr, widest);
    return corner.y + size.y + gap;
}

void draw_count(const CrystalSearch& search) {
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const float size = ImGui::GetFontSize();
    centred_text(ImVec2(screen.GetCenter().x, size * 0.6f), fmt::format("{} of {} crystals awake", search.awake, search.all), search.awake == search.all ? IM_COL32(255, 230, 140, 255) : text_colour);
}

/// Two swatches side by side, wanted and arriving, and a bar of how much of the way is done.
float draw_light(ImVec2 top, const Crystal& crystal, const CrystalLight& light) {
    const float size = ImGui::GetFontSize(), width = size * 14.0f;
    const ImVec2 corner(std::round(top.x - 0.5f * width), top.y);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(corner, ImVec2(corner.x + width, corner.y + size), ground, size * 0.2f);
    list.AddRectFilled(corner, ImVec2(corner.x + width * light.share(crystal), corner.y + size), hue(crystal.colour), size * 0.2f);
    list.AddRectFilled(ImVec2(corner.x - 1.4f * size, corner.y), ImVec2(corner.x - 0.4f * size, corner.y + size), hue(crystal.colour), size * 0.2f);
    list.AddRectFilled(ImVec2(corner.x + width + 0.4f * size, corner.y), ImVec2(corner.x + width + 1.4f * size, corner.y + size), hue(light.irradiance), size * 0.2f);
    return corner.y + size * 1.4f;
}

const char* what_lacks(const Crystal& crystal, const CrystalLight& light) {
    if (light.amount < 1.0f && light.match < crystal.purity) return "too little reflected light, and of another colour";
    if (light.amount < 1.0f) return "the right colour, but too little reflected light";
    if (light.match < crystal.purity) return "enough reflected light, but of another colour";
    return "it stirs";
}

void draw_nearest(World& world, const CrystalSearch& search) {
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    ImVec2 at(screen.GetCenter().x, ImGui::GetFontSize() * 2.4f);
    if (search.nearest && search.distance < shown_within && world.alive(search.nearest)) {
        const Crystal& crystal = world.get<Crystal>(search.nearest);
        const auto* name = world.find<Name>(search.nearest);
        const std::string title = name != nullptr ? name->value : "a crystal";
        at.y = centred_text(at, search.light ? fmt::format("{} sleeps: {}", title, what_lacks(crystal, *search.light)) : title + " sleeps", text_colour);
        if (search.light) at.y = draw_light(ImVec2(at.x, at.y + 2.0f), crystal, *search.light);
        if (search.hint.empty()) centred_text(at, "T  hint", faint);
    }
    if (!search.hint.empty()) centred_text(at, search.hint, text_colour);
}

/// Sparks that fly from the middle of the screen and fall; each by its number alone.
void draw_celebration(World& world, double seconds_left) {
    std::vector<vec3> colours;
    for (auto [entity, crystal] : Query<const Crystal>(world)) {
        if (crystal.awake) colours.push_back(crystal.colour);
    }
    if (colours.empty()) return;
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const ImVec2 centre = screen.GetCenter();
    const float period = 3.0f, size = ImGui::GetFontSize() * 0.22f;
    const auto left = static_cast<float>(seconds_left);
    for (int i = 0; i < sparks; ++i) {
        const float turn = 2.399963f * static_cast<float>(i), start = std::fmod(0.618034f * static_cast<float>(i), 1.0f);
        const float age = std::fmod(start + 100.0f - left / period, 1.0f), speed = 0.25f + 0.35f * std::fmod(0.7548777f * static_cast<float>(i), 1.0f);
        const float x = centre.x + std::cos(turn) * speed * age * screen.Size.y, y = centre.y + (std::sin(turn) * speed * age + 0.5f * age * age) * screen.Size.y;
        const ImU32 colour = hue(colours[static_cast<std::size_t>(i) % colours.size()]);
        const auto fade = static_cast<ImU32>(255.0f * (1.0f - age) * std::min(1.0f, left));
        ImGui::GetBackgroundDrawList()->AddCircleFilled(ImVec2(x, y), size * (1.0f + age), (colour & ~IM_COL32_A_MASK) | (fade << IM_COL32_A_SHIFT), 6);
    }
}

}  // namespace

void draw_crystal_search(World& world) {
    const auto* search = world.find_resource<CrystalSearch>();
    if (search == nullptr || search->all == 0) return;
    draw_count(*search);
    draw_nearest(world, *search);
    if (search->celebration > 0.0) draw_celebration(world, search->celebration);
}

}  // namespace sl
