// SPDX-License-Identifier: MIT
#include "editor/component_widgets.h"

#include <imgui.h>

#include "editor/entity_edits.h"
#include "editor/entity_tree.h"
#include "editor/imgui_fields.h"
#include "engine/core/field_clamp.h"

namespace sl {

bool edit_component(const EditedScene& scene, const ComponentType& type, Entity entity) {
    const EntityParts parts = scene.parts();
    PartValue before = parts.read(entity, type.name);
    ImguiFields fields;
    {
        const FieldTable table(type.name.c_str());
        if (!table) return false;
        type.visit(scene.world, entity, fields);
    }
    if (!fields.changed()) return false;
    FieldClamp clamp;
    type.visit(scene.world, entity, clamp);
    scene.history.add_to_gesture(
        fmt::format("{}.{}.{}", shown_name(scene.world, entity), type.name, fields.changed_field()),
        {scene.history.keys().key_of(entity), type.name, std::move(before), parts.read(entity, type.name)});
    return true;
}

void component_section(const EditedScene& scene, const ComponentType& type, Entity entity, bool open_at_first) {
    bool kept = true;
    if (ImGui::CollapsingHeader(type.name.c_str(), &kept,
                                open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0)) {
        edit_component(scene, type, entity);
    }
    if (!kept) remove_component(scene, entity, type);
}

void add_component_list(const EditedScene& scene, Entity entity) {
    if (!ImGui::BeginCombo("##add", "add a component", ImGuiComboFlags_NoArrowButton)) return;
    for (const ComponentType& type : scene.registry.types()) {
        if (type.has(scene.world, entity)) continue;
        if (ImGui::Selectable(type.name.c_str())) add_component(scene, entity, type);
    }
    ImGui::EndCombo();
}

}  // namespace sl
