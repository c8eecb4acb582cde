// SPDX-License-Identifier: MIT
#include "editor/component_widgets.h"

#include <imgui.h>

#include "editor/imgui_fields.h"
#include "engine/core/field_clamp.h"

namespace sl {

bool edit_component(World& world, const ComponentType& type, Entity entity) {
    ImguiFields fields;
    {
        const FieldTable table(type.name.c_str());
        if (!table) return false;
        type.visit(world, entity, fields);
    }
    if (!fields.changed()) return false;
    FieldClamp clamp;
    type.visit(world, entity, clamp);
    return true;
}

void component_section(World& world, const ComponentType& type, Entity entity, bool open_at_first) {
    bool kept = true;
    if (ImGui::CollapsingHeader(type.name.c_str(), &kept,
                                open_at_first ? ImGuiTreeNodeFlags_DefaultOpen : 0)) {
        edit_component(world, type, entity);
    }
    if (!kept) type.remove(world, entity);
}

void add_component_list(World& world, const ComponentRegistry& registry, Entity entity) {
    if (!ImGui::BeginCombo("##add", "add a component", ImGuiComboFlags_NoArrowButton)) return;
    for (const ComponentType& type : registry.types()) {
        if (type.has(world, entity)) continue;
        if (ImGui::Selectable(type.name.c_str())) type.add_default(world, entity);
    }
    ImGui::EndCombo();
}

}  // namespace sl
