// SPDX-License-Identifier: MIT
#include "editor/see/probe_table.h"

#include <imgui.h>

#include <algorithm>

#include "editor/entity_tree.h"
#include "engine/ecs/components.h"
#include "engine/ecs/parent.h"

namespace sl {

namespace {

constexpr std::size_t most_lights = 8;

void row(const char* name, const std::string& value) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", name);
    ImGui::TableNextColumn();
    ImGui::TextWrapped("%s", value.c_str());
}

std::string coordinates(const dvec3& v) { return fmt::format("{:.2f}, {:.2f}, {:.2f}", v.x, v.y, v.z); }

/// A brightness, and its colour where it has one.
std::string light(vec3 value, const char* unit) {
    const float brightness = luminance(value);
    if (!(brightness > 0.0f)) return fmt::format("0 {}", unit);
    const vec3 colour = value / std::max({value.x, value.y, value.z});
    return fmt::format("{:.4g} {} ({:.2f}, {:.2f}, {:.2f})", brightness, unit, colour.x, colour.y, colour.z);
}

/// Parts without a name, such as a terrain's chunks, belong to the first above them that has one.
std::string owner(const World& world, Entity entity) {
    while (world.alive(entity) && !world.has<Name>(entity) && world.has<Parent>(entity)) entity = world.get<Parent>(entity).entity;
    return world.alive(entity) ? shown_name(world, entity) : "none that is known";
}

void live_rows(const ProbeReading& reading) {
    if (!reading.live) return row("live", "hidden from the camera");
    row("albedo", fmt::format("{:.2f}, {:.2f}, {:.2f}", reading.live->albedo.x, reading.live->albedo.y, reading.live->albedo.z));
    row("radiance", light(reading.live->radiance, "nit"));
    row("of that direct", light(reading.live->direct, "nit"));
    row("indirect", light(reading.live->irradiance, "lux"));
}

void truth_rows(const ProbeReading& reading) {
    if (!reading.truth) return row("path traced", "not yet");
    const LightMeter::Reading& truth = *reading.truth;
    row("path traced", light(truth.irradiance, "lux"));
    row("its noise", fmt::format("{:.1f} %", 100.0f * truth.noise));
    row("of that bounced", light(truth.bounced, "lux"));
    const float right = luminance(truth.irradiance);
    if (reading.live && right > 0.0f) row("live is off by", fmt::format("{:+.1f} %", 100.0f * (luminance(reading.live->irradiance) / right - 1.0f)));
}

void light_rows(const World& world, const ProbeReading& reading) {
    row(reading.shadowed ? "direct" : "unshadowed", light(arriving(reading.lights), "lux"));
    for (std::size_t i = 0; i < std::min(reading.lights.size(), most_lights); ++i) {
        const LightShare& share = reading.lights[i];
        ImGui::PushID(static_cast<int>(i));
        row(owner(world, share.light).c_str(), fmt::format("{:.4g} lux{}", luminance(share.irradiance), share.blocked ? ", in shadow" : ""));
        ImGui::PopID();
    }
    if (reading.lights.size() > most_lights) row("", fmt::format("and {} weaker lights", reading.lights.size() - most_lights));
}

void texel_rows(const TexelShares& texels) {
    float drawn = 0.0f;
    for (const TexelShare& share : texels.strongest) drawn += luminance(share.irradiance);
    const float sum = luminance(texels.sum);
    row("all RSM texels", light(texels.sum, "lux"));
    if (sum > 0.0f) row("", fmt::format("{:.1f} % by the {} with lines", 100.0f * drawn / sum, texels.strongest.size()));
}

}  // namespace

void probe_table(const World& world, const ProbeReading& reading) {
    if (!ImGui::BeginTable("probe", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) return;
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed);
    ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthStretch);
    row("entity", owner(world, reading.entity));
    row("position", coordinates(reading.point.position) + " m");
    row("normal", coordinates(dvec3(reading.point.normal)));
    row("distance", fmt::format("{:.2f} m", reading.distance));
    live_rows(reading);
    truth_rows(reading);
    if (reading.texels) texel_rows(*reading.texels);
    light_rows(world, reading);
    ImGui::EndTable();
}

}  // namespace sl
