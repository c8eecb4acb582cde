// SPDX-License-Identifier: MIT
#include "editor/scene_file_bar.h"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <ranges>

#include "editor/entity_tree.h"
#include "engine/core/error.h"
#include "engine/core/json_text.h"
#include "engine/core/text_file.h"
#include "engine/ecs/scene_document.h"
#include "engine/ecs/scene_file.h"

namespace sl {

namespace {

constexpr const char* replace_popup = "Replace the file?";

/// The scene's own name in the current folder.
std::string usual_path(const World& world) {
    const auto* info = world.find_resource<SceneInfo>();
    const std::string stem = info == nullptr ? "" : info->path.stem().string();
    return (stem.empty() ? "scene" : stem) + ".json";
}

/// What a scene file holds that saving over it would not write again; empty where that is nothing.
std::string lost_by_replacing(const std::string& path) {
    try {
        const std::string text = read_text_file(path, most_scene_bytes);
        const std::string plain = without_comments(text);
        const bool includes = parse_json(plain, path).contains(scene_key::include);
        return fmt::format("{}{}", plain == text ? "" : " Its comments would be lost.", includes ? " What it includes would stand in it instead." : "");
    } catch (const Error&) {
        return "";  // no scene, so nothing of one is lost
    }
}

void ask_before_replacing(const EditedScene& scene, SceneFileBar& state) {
    if (!ImGui::BeginPopupModal(replace_popup, nullptr, ImGuiWindowFlags_AlwaysAutoResize)) return;
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 20.0f);
    ImGui::Text("There is already a file %s.%s", state.path.c_str(), state.lost.c_str());
    ImGui::PopTextWrapPos();
    if (ImGui::Button("Replace it")) {
        state.outcome = save_scene(scene, state.path);
        ImGui::CloseCurrentPopup();
    }
    ImGui::SameLine();
    if (ImGui::Button("Leave it")) ImGui::CloseCurrentPopup();
    ImGui::SetItemDefaultFocus();
    ImGui::EndPopup();
}

/// The named entities, each after its parent.
std::vector<Entity> parents_first(const World& world) {
    const EntityTree tree(world);
    std::vector<Entity> all;
    for (const Entity root : tree.roots()) {
        const std::vector<Entity> branch = with_all_below(world, root);
        all.insert(all.end(), branch.begin(), branch.end());
    }
    return all;
}

}  // namespace

Outcome save_scene(const EditedScene& scene, const std::string& path) {
    try {
        write_scene(scene.world, scene.registry, path);
        SceneInfo info = scene.world.find_resource<SceneInfo>() != nullptr ? scene.world.resource<SceneInfo>() : SceneInfo{};
        // The world keeps its names of files, and with them whatever undo brings back.
        info.folder = std::filesystem::current_path() / references_folder(scene.world);
        info.path = path;
        scene.world.add_resource(std::move(info));
        scene.history.mark_saved();
        return {fmt::format("saved {}", std::filesystem::absolute(path).string())};
    } catch (const std::exception& error) {
        return {error.what(), true};
    }
}

Outcome reload_scene(const EditedScene& scene) {
    const auto* info = scene.world.find_resource<SceneInfo>();
    if (info == nullptr) return {"this scene has no file yet: save it", true};
    const std::filesystem::path path = info->path;
    const std::vector<Entity> before = parents_first(scene.world);
    try {
        read_scene(scene.world, scene.registry, path);
    } catch (const std::exception& error) {
        return {error.what(), true};
    }
    const std::vector<Entity> both = parents_first(scene.world);
    {
        SceneEdit edit(scene, fmt::format("reload {}", path.filename().string()));
        for (const Entity entity : before | std::views::reverse) edit.destroy(entity);
        for (const Entity entity : both) {
            if (scene.world.alive(entity)) edit.adopt(entity);
        }
    }
    scene.history.mark_saved();
    return {fmt::format("read {}", path.string())};
}

void scene_file_bar(const EditedScene& scene, SceneFileBar& state) {
    // Not while somebody types: they may have emptied it to write another one.
    if (state.path.empty() && !ImGui::IsAnyItemActive()) state.path = usual_path(scene.world);
    // Its name stays the same for ImGui, or the button would not keep its focus.
    if (ImGui::Button(scene.history.saved() ? "Save###save" : "Save *###save")) {
        std::error_code ignored;
        if (std::filesystem::exists(state.path, ignored)) {
            state.lost = lost_by_replacing(state.path);
            ImGui::OpenPopup(replace_popup);
        } else {
            state.outcome = save_scene(scene, state.path);
        }
    }
    if (!scene.history.saved() && ImGui::IsItemHovered()) ImGui::SetTooltip("There are changes that no file holds.");
    ImGui::SameLine();
    if (ImGui::Button("Reload")) state.outcome = reload_scene(scene);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Puts back what the scene's file holds; can be undone.");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-std::numeric_limits<float>::min());
    ImGui::InputText("##path", &state.path);
    ask_before_replacing(scene, state);
    show(state.outcome);
}

}  // namespace sl
