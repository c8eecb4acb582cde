// SPDX-License-Identifier: MIT
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "editor/component_widgets.h"
#include "editor/editor_panel.h"
#include "engine/ecs/components.h"
#include "engine/ecs/query.h"

namespace sl {

namespace {

constexpr std::array<std::string_view, 5> light_components{"sun", "directional_light", "spot_light",
                                                           "point_light", "sky"};

Entity rendered_camera(World& world) {
    for (auto [entity, camera] : Query<const Camera>(world)) {
        if (camera.active) return entity;
    }
    return {};
}

struct NamedEntity {
    std::string name;
    Entity entity;
};

/// By name; a copy, because editing adds and removes components.
std::vector<NamedEntity> named_entities(World& world) {
    std::vector<NamedEntity> named;
    for (auto [entity, name] : Query<const Name>(world)) named.push_back({name.value, entity});
    std::ranges::sort(named, {}, [](const NamedEntity& n) { return std::pair(n.name, n.entity); });
    return named;
}

/// Two entities may share a name, and any widget inside belongs to one of them.
bool begin_entity(const NamedEntity& named, ImGuiTreeNodeFlags flags = 0) {
    return ImGui::TreeNodeEx(reinterpret_cast<void*>(std::uintptr_t{named.entity.index} + 1), flags, "%s",
                             named.name.empty() ? "(no name)" : named.name.c_str());
}

void gi_section(World& world, const ComponentRegistry& registry, Entity camera) {
    if (!ImGui::CollapsingHeader("Global illumination", ImGuiTreeNodeFlags_DefaultOpen)) return;
    ImGui::PushID("gi");
    const ComponentType& gi = *registry.find("gi");
    if (!camera) {
        ImGui::TextWrapped("No camera is active.");
    } else if (const auto* settings = world.find<GiSettings>(camera)) {
        const std::string_view claims = gi_method_claims(settings->method);
        ImGui::PushTextWrapPos(0.0f);
        ImGui::TextDisabled("%.*s", static_cast<int>(claims.size()), claims.data());
        ImGui::PopTextWrapPos();
        edit_component(world, gi, camera);
        if (ImGui::Button("Remove")) gi.remove(world, camera);
    } else {
        ImGui::TextWrapped("The camera has no GI settings: no indirect light is computed.");
        if (ImGui::Button("Add GI settings")) gi.add_default(world, camera);
    }
    ImGui::PopID();
}

void light_sections(World& world, const ComponentRegistry& registry, std::span<const NamedEntity> entities) {
    if (!ImGui::CollapsingHeader("Lights", ImGuiTreeNodeFlags_DefaultOpen)) return;
    ImGui::PushID("lights");
    for (const NamedEntity& named : entities) {
        const auto is_lit_by = [&](std::string_view name) {
            return registry.find(name)->has(world, named.entity);
        };
        if (std::ranges::none_of(light_components, is_lit_by) || !begin_entity(named)) continue;
        for (const std::string_view name : light_components) {
            const ComponentType& type = *registry.find(name);
            if (!type.has(world, named.entity)) continue;
            ImGui::TextDisabled("%s", type.name.c_str());
            edit_component(world, type, named.entity);
        }
        ImGui::TreePop();
    }
    ImGui::PopID();
}

void camera_section(World& world, const ComponentRegistry& registry, Entity camera) {
    if (!camera || !ImGui::CollapsingHeader("Camera and exposure")) return;
    ImGui::PushID("camera");
    edit_component(world, *registry.find("camera"), camera);
    ImGui::PopID();
}

void entity_section(World& world, const ComponentRegistry& registry, std::span<const NamedEntity> entities,
                    EditorState& state) {
    if (!ImGui::CollapsingHeader("All entities")) return;
    ImGui::PushID("entities");
    ImGui::SetNextItemWidth(-std::numeric_limits<float>::min());
    ImGui::InputTextWithHint("##filter", "find by name", &state.filter);
    for (const NamedEntity& named : entities) {
        if (named.name.find(state.filter) == std::string::npos || !begin_entity(named)) continue;
        for (const ComponentType& type : registry.types()) {
            if (type.has(world, named.entity)) component_section(world, type, named.entity, false);
        }
        add_component_list(world, registry, named.entity);
        ImGui::TreePop();
    }
    ImGui::PopID();
}

}  // namespace

void scene_sections(App& app, EditorState& state) {
    World& world = app.world;
    const ComponentRegistry& registry = app.registry();
    const Entity camera = rendered_camera(world);
    const std::vector<NamedEntity> entities = named_entities(world);
    gi_section(world, registry, camera);
    light_sections(world, registry, entities);
    camera_section(world, registry, camera);
    entity_section(world, registry, entities, state);
}

}  // namespace sl
