// SPDX-License-Identifier: MIT
#include "editor/imgui_fields.h"
#include "game/menu/menu_window.h"
#include "game/menu/pages.h"

namespace sl {

namespace {

void edit_new_world(Menu& menu) {
    std::vector<std::string_view> scenes;
    for (const SceneListing& scene : menu.scenes) scenes.push_back(scene.name);
    const FieldTable table("new world");
    if (!table) return;
    ImguiFields fields;
    fields.field("name", menu.new_name, {.help = "Names the world's file."});
    fields.choice("scene", menu.new_scene, scenes, {.help = "With which the world begins."});
}

}  // namespace

void new_world_page(Menu& menu, MenuWish& wish) {
    const MenuWindow window("New world", 36.0f);
    edit_new_world(menu);
    if (menu.new_scene < menu.scenes.size()) menu_text(menu.scenes[menu.new_scene].description);
    ImGui::Spacing();
    const std::string fault = menu.scenes.empty() ? "there are no scenes" : fault_of_name(menu.folder, menu.new_name);
    menu_problem(fault.empty() ? menu.problem : fault);
    ImGui::BeginDisabled(!fault.empty());
    // A keyboard presses even a disabled button, where that has the focus from the start.
    if (menu_button("Make it and play") && fault.empty()) wish.world = WorldChoice{world_path(menu.folder, menu.new_name), menu.scenes[menu.new_scene].name};
    if (ImGui::IsWindowAppearing()) ImGui::SetItemDefaultFocus();
    ImGui::EndDisabled();
    if (menu_button("Back")) go_back(menu);
}

}  // namespace sl
