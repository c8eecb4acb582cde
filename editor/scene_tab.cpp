// SPDX-License-Identifier: MIT
#include "editor/scene_tab.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>

#include "editor/entity_edits.h"
#include "editor/entity_tree.h"
#include "editor/inspector.h"
#include "engine/ecs/active_camera.h"

namespace sl {

namespace {

constexpr float tree_lines = 9.0f;
/// Where a new entity is put, m before the camera.
constexpr double new_distance = 3.0;

bool contains(std::string_view text, std::string_view part) {
    const auto same = [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); };
    return !std::ranges::search(text, part, same).empty() || part.empty();
}

Transform place_before_camera(World& world) {
    const Entity camera = active_camera(world);
    const auto* eye = camera ? world.find<WorldTransform>(camera) : nullptr;
    if (eye == nullptr) return {};
    return {.translation = eye->origin - glm::normalize(dvec3(eye->linear[2])) * new_distance};
}

/// One line of the tree; returns whether it is open.
bool line(const EditedScene& scene, Entity entity, SceneTab& state, ImGuiTreeNodeFlags flags) {
    const EntityKey key = scene.history.keys().key_of(entity);
    if (key == state.selected) flags |= ImGuiTreeNodeFlags_Selected;
    flags |= ImGuiTreeNodeFlags_SpanAvailWidth | ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_OpenOnDoubleClick;
    const auto id = static_cast<std::uintptr_t>(key);
    const bool open = ImGui::TreeNodeEx(reinterpret_cast<void*>(id), flags, "%s", shown_name(scene.world, entity).c_str());
    // The line that the keyboard is on is the chosen one, so that Delete and the inspector are about it.
    if (ImGui::IsItemClicked() || (ImGui::IsItemFocused() && ImGui::GetIO().NavVisible)) state.selected = key;
    return open;
}

void branch(const EditedScene& scene, const EntityTree& tree, Entity entity, SceneTab& state) {
    const std::vector<Entity>& children = tree.below(entity);
    const ImGuiTreeNodeFlags flags = children.empty() ? ImGuiTreeNodeFlags_Leaf : ImGuiTreeNodeFlags_DefaultOpen;
    if (!line(scene, entity, state, flags)) return;
    for (const Entity child : children) branch(scene, tree, child, state);
    ImGui::TreePop();
}

void tree_list(const EditedScene& scene, SceneTab& state) {
    ImGui::SetNextItemWidth(-std::numeric_limits<float>::min());
    ImGui::InputTextWithHint("##filter", "find by name", &state.filter);
    const EntityTree tree(scene.world);
    const float height = std::min(tree_lines * ImGui::GetTextLineHeightWithSpacing(), 0.4f * ImGui::GetWindowHeight());
    ImGui::BeginChild("tree", ImVec2(0.0f, height), true, ImGuiWindowFlags_NavFlattened);
    if (state.filter.empty()) {
        for (const Entity root : tree.roots()) branch(scene, tree, root, state);
    } else {
        for (const Entity entity : tree.all()) {
            constexpr ImGuiTreeNodeFlags flat = ImGuiTreeNodeFlags_Leaf | ImGuiTreeNodeFlags_NoTreePushOnOpen;
            if (contains(shown_name(scene.world, entity), state.filter)) line(scene, entity, state, flat);
        }
    }
    ImGui::EndChild();
}

bool delete_key() {
    return ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows) && !ImGui::IsAnyItemActive() &&
           ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Delete), false);
}

/// What can be done with entities as wholes.
void entity_buttons(const EditedScene& scene, SceneTab& state) {
    const auto select = [&](Entity entity) { state.selected = scene.history.keys().key_of(entity); };
    if (ImGui::Button("Add")) select(add_entity(scene, place_before_camera(scene.world)));
    const Entity chosen = selected_entity(scene, state);
    ImGui::BeginDisabled(!chosen);
    ImGui::SameLine();
    if (ImGui::Button("Duplicate")) select(duplicate_entity(scene, chosen));
    ImGui::SameLine();
    if (ImGui::Button("Delete") || (chosen && delete_key())) delete_entity(scene, chosen);
    ImGui::EndDisabled();
}

}  // namespace

Entity selected_entity(const EditedScene& scene, const SceneTab& state) {
    const Entity entity = scene.history.keys().entity_of(state.selected);
    return scene.world.alive(entity) ? entity : Entity{};
}

void scene_tab(const EditedScene& scene, SceneTab& state) {
    scene_file_bar(scene, state.file);
    ImGui::Separator();
    entity_buttons(scene, state);
    tree_list(scene, state);
    if (const Entity chosen = selected_entity(scene, state)) {
        inspector(scene, chosen);
    } else {
        ImGui::TextDisabled("Choose an entity to see its components.");
    }
}

}  // namespace sl
