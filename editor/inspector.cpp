// SPDX-License-Identifier: MIT
#include "editor/inspector.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "editor/component_widgets.h"
#include "editor/entity_edits.h"
#include "editor/entity_tree.h"
#include "editor/imgui_fields.h"
#include "editor/outcome.h"
#include "engine/ecs/components/name.h"
#include "engine/ecs/parent.h"

namespace sl {

namespace {

bool name_is_shared(const World& world, std::string_view name) {
    const auto named = EntityTree(world).all();
    return std::ranges::count(named, name, [&](Entity entity) { return std::string_view(world.get<Name>(entity).value); }) > 1;
}

void name_field(const EditedScene& scene, Entity entity) {
    const std::string before = scene.world.get<Name>(entity).value;
    std::string name = before;
    ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 4.0f);
    if (ImGui::InputText("name", &name)) {
        scene.world.get<Name>(entity).value = name;
        scene.history.add_to_gesture(fmt::format("name of {}", before),
                                     {scene.history.keys().key_of(entity), std::string(entity_part::name), before, name});
    }
    if (name.empty()) warning_text("A scene with a nameless entity cannot be saved.");
    if (name_is_shared(scene.world, name)) warning_text("Another entity has this name: the scene cannot be saved.");
}

void parent_field(const EditedScene& scene, Entity entity) {
    const Parent* parent = scene.world.find<Parent>(entity);
    const Entity now = parent != nullptr && scene.world.alive(parent->entity) ? parent->entity : Entity{};
    ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 4.0f);
    if (!ImGui::BeginCombo("parent", now ? shown_name(scene.world, now).c_str() : "(none)")) return;
    if (ImGui::Selectable("(none)", !now)) set_parent(scene, entity, {});
    const std::vector<Entity> below = with_all_below(scene.world, entity);
    for (const Entity other : EntityTree(scene.world).all()) {
        if (std::ranges::count(below, other) > 0) continue;
        ImGui::PushID(static_cast<int>(other.index));
        if (ImGui::Selectable(shown_name(scene.world, other).c_str(), other == now)) set_parent(scene, entity, other);
        ImGui::PopID();
    }
    ImGui::EndCombo();
}

}  // namespace

void inspector(const EditedScene& scene, Entity entity) {
    ImGui::PushID(static_cast<int>(entity.index));
    name_field(scene, entity);
    parent_field(scene, entity);
    for (const ComponentType& type : scene.registry.types()) {
        if (type.has(scene.world, entity)) component_section(scene, type, entity, true);
    }
    add_component_list(scene, entity);
    ImGui::PopID();
}

}  // namespace sl
