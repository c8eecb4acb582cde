// SPDX-License-Identifier: MIT
#include "editor/light_tab.h"

#include <imgui.h>

#include <algorithm>

#include "editor/component_widgets.h"
#include "editor/entity_edits.h"
#include "editor/entity_tree.h"
#include "engine/ecs/active_camera.h"
#include "engine/ecs/components.h"
#include "engine/render/frame.h"

namespace sl {

namespace {

constexpr std::array<std::string_view, 5> light_components{"sun", "directional_light", "spot_light",
                                                           "point_light", "sky"};

void gi_section(const EditedScene& scene, Entity camera) {
    if (!ImGui::CollapsingHeader("Global illumination", ImGuiTreeNodeFlags_DefaultOpen)) return;
    ImGui::PushID("gi");
    const ComponentType& gi = *scene.registry.find("gi");
    if (!camera) {
        ImGui::TextWrapped("No camera is active.");
    } else if (const auto* settings = scene.world.find<GiSettings>(camera)) {
        const std::string_view claims = settings->method.claims();
        ImGui::PushTextWrapPos(0.0f);
        ImGui::TextDisabled("%.*s", static_cast<int>(claims.size()), claims.data());
        ImGui::PopTextWrapPos();
        edit_component(scene, gi, camera);
        if (ImGui::Button("Remove")) remove_component(scene, camera, gi);
    } else {
        ImGui::TextWrapped("The camera has no GI settings: no indirect light is computed.");
        if (ImGui::Button("Add GI settings")) add_component(scene, camera, gi);
    }
    ImGui::PopID();
}

/// What rsm_disc reads for a pixel, on average: all samples where it gathers in full, and those of the
/// low-resolution gather.
void disc_figures(const RsmDisc& disc, double refined) {
    const double low_pixels = 1.0 / (double(disc.low_resolution) * disc.low_resolution);
    const double samples = disc.samples * (disc.interpolate ? refined + low_pixels : 1.0);
    ImGui::TextWrapped("%.1f %% of pixels gathered in full, %.1f samples per pixel", 100.0 * refined, samples);
}

void gi_times(const FrameReport& report, const GiSettings* settings, LightTab& state) {
    std::vector<gl::SpanTime> times;
    std::ranges::copy_if(report.times, std::back_inserter(times),
                         [](const gl::SpanTime& time) { return time.group == gi_group; });
    if (report.traced_milliseconds > 0.0) times.push_back({tracing_name, "", report.traced_milliseconds});
    if (report.drawn) state.history.add(times);
    if (!ImGui::CollapsingHeader("GI time", ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (state.history.frames() > 0) {
        ImGui::Text("%.2f ms in %zu passes", static_cast<double>(state.history.sum(state.history.frames() - 1)), times.size());
        draw_pass_history(state.history);
    }
    if (report.noise) ImGui::Text("noise %.1f %% of the irradiance", 100.0 * static_cast<double>(*report.noise));
    if (report.progress < 1.0f) ImGui::Text("%.1f %% done", 100.0 * static_cast<double>(report.progress));
    const auto* disc = settings == nullptr ? nullptr : settings->method.get_if<RsmDisc>();
    if (disc != nullptr && report.refined) disc_figures(*disc, *report.refined);
}

bool is_light(const EditedScene& scene, Entity entity) {
    return std::ranges::any_of(light_components, [&](std::string_view name) { return scene.registry.find(name)->has(scene.world, entity); });
}

void edit_light(const EditedScene& scene, Entity entity) {
    for (const std::string_view name : light_components) {
        const ComponentType& type = *scene.registry.find(name);
        if (!type.has(scene.world, entity)) continue;
        ImGui::TextDisabled("%s", type.name.c_str());
        edit_component(scene, type, entity);
    }
}

void light_section(const EditedScene& scene) {
    if (!ImGui::CollapsingHeader("Lights")) return;
    ImGui::PushID("lights");
    for (const Entity entity : EntityTree(scene.world).all()) {
        if (!is_light(scene, entity)) continue;
        // Two entities may share a name, and any widget inside belongs to one of them.
        const auto id = std::uintptr_t{entity.index} + 1;
        if (!ImGui::TreeNodeEx(reinterpret_cast<void*>(id), 0, "%s", shown_name(scene.world, entity).c_str())) continue;
        edit_light(scene, entity);
        ImGui::TreePop();
    }
    ImGui::PopID();
}

void camera_section(const EditedScene& scene, Entity camera) {
    if (!camera || !ImGui::CollapsingHeader("Camera and exposure")) return;
    ImGui::PushID("camera");
    edit_component(scene, *scene.registry.find("camera"), camera);
    ImGui::PopID();
}

}  // namespace

void light_tab(const EditedScene& scene, const FrameReport& report, LightTab& state) {
    const Entity camera = active_camera(scene.world);
    gi_section(scene, camera);
    gi_times(report, camera ? scene.world.find<GiSettings>(camera) : nullptr, state);
    light_section(scene);
    camera_section(scene, camera);
}

}  // namespace sl
