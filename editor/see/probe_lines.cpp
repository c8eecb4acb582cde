// SPDX-License-Identifier: MIT
#include "editor/see/probe_lines.h"

#include <algorithm>
#include <cmath>

namespace sl {

namespace {

constexpr ImU32 dark = IM_COL32(0, 0, 0, 200), bright = IM_COL32(255, 255, 255, 255), shadowed = IM_COL32(120, 130, 150, 120);
constexpr std::size_t most_lights = 8;

/// The hue of light, and as much in the way as it brings.
ImU32 colour_of(vec3 light, float share) {
    const vec3 hue = light / std::max({light.x, light.y, light.z, 1e-30f});
    return ImGui::ColorConvertFloat4ToU32(ImVec4(hue.x, hue.y, hue.z, 0.25f + 0.75f * std::sqrt(share)));
}

void draw_texels(const ProbeReading& reading, const Projection& project, float width) {
    if (!reading.texels || reading.texels->strongest.empty()) return;
    const auto& texels = reading.texels->strongest;
    const float strongest = luminance(texels.front().irradiance);
    for (const TexelShare& texel : texels) {
        const float share = luminance(texel.irradiance) / strongest;
        project.line(texel.position, reading.point.position, colour_of(texel.irradiance, share), width);
        if (const auto at = project.at(texel.position)) ImGui::GetBackgroundDrawList()->AddCircleFilled(*at, 2.0f * width, colour_of(texel.irradiance, 1.0f));
    }
}

void draw_lights(const ProbeReading& reading, const Projection& project, float width) {
    for (std::size_t i = 0; i < std::min(reading.lights.size(), most_lights); ++i) {
        const LightShare& share = reading.lights[i];
        project.line(share.from, reading.point.position, share.blocked ? shadowed : colour_of(share.irradiance, 1.0f), width);
    }
}

void draw_cross(ImVec2 at, float scale) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float arm = 8.0f * scale;
    for (const auto& [colour, width] : {std::pair{dark, 4.0f * scale}, std::pair{bright, 1.5f * scale}}) {
        list.AddLine(ImVec2(at.x - arm, at.y), ImVec2(at.x + arm, at.y), colour, width);
        list.AddLine(ImVec2(at.x, at.y - arm), ImVec2(at.x, at.y + arm), colour, width);
    }
}

}  // namespace

void draw_probe_lines(const ProbeReading& reading, const Projection& project, float scale) {
    draw_texels(reading, project, scale);
    draw_lights(reading, project, 2.5f * scale);
    if (const auto at = project.at(reading.point.position)) draw_cross(*at, scale);
}

}  // namespace sl
