// SPDX-License-Identifier: MIT
#include <fmt/chrono.h>

#include "game/menu/menu_window.h"
#include "game/menu/pages.h"

namespace sl {

namespace {

std::string size_text(std::uintmax_t bytes) {
    constexpr double kibi = 1024.0;
    const auto size = static_cast<double>(bytes);
    return size < kibi * kibi ? fmt::format("{:.0f} KiB", std::ceil(size / kibi)) : fmt::format("{:.1f} MiB", size / (kibi * kibi));
}

std::string time_text(std::filesystem::file_time_type time) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(std::chrono::file_clock::to_sys(time).time_since_epoch());
    return fmt::format("{:%Y-%m-%d %H:%M}", fmt::localtime(static_cast<std::time_t>(seconds.count())));
}

void world_row(Menu& menu, const WorldEntry& world, MenuWish& wish) {
    ImGui::PushID(world.path.c_str());
    ImGui::Separator();
    ImGui::TextUnformatted(world.name.c_str());
    ImGui::SameLine();
    ImGui::TextDisabled("%s", world.open ? "is played now" : time_text(world.last_played).c_str());
    if (!world.fault.empty()) {
        menu_problem(world.fault);
    } else {
        ImGui::TextDisabled("%s, %s", world.scene.c_str(), size_text(world.bytes).c_str());
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::GetFontSize() * 8.0f);
        if (ImGui::SmallButton(world.open ? "Resume" : "Play")) wish.world = WorldChoice{world.path, {}};
        if (!world.open) {
            ImGui::SameLine();
            if (ImGui::SmallButton("Delete")) {
                show_page(menu, MenuPage::delete_world);
                menu.chosen = world.path;
            }
        }
    }
    ImGui::PopID();
}

/// "World 1", or the first number that is free.
std::string free_name(const std::filesystem::path& folder) {
    for (int number = 1;; ++number) {
        std::string name = fmt::format("World {}", number);
        if (fault_of_name(folder, name).empty()) return name;
    }
}

void begin_new_world(Menu& menu) {
    show_page(menu, MenuPage::new_world);
    menu.new_name = free_name(menu.folder);
    menu.scenes = scene_names();
    const auto usual = std::ranges::find(menu.scenes, SceneChoice{}.scene, &SceneListing::name);
    menu.new_scene = usual != menu.scenes.end() ? static_cast<std::size_t>(usual - menu.scenes.begin()) : 0;
}

}  // namespace

void show_worlds(Menu& menu, const WorldFile* open) {
    show_page(menu, MenuPage::worlds);
    menu.worlds = list_worlds(menu.folder, open);
}

void worlds_page(Menu& menu, MenuWish& wish) {
    const MenuWindow window("Worlds", 40.0f);
    if (menu_button("New world")) {
        try {
            begin_new_world(menu);
        } catch (const std::exception& error) {
            menu.problem = error.what();
        }
    }
    if (menu_button("Back")) go_back(menu);
    menu_problem(menu.problem);
    if (menu.worlds.empty()) menu_text("There are no worlds yet in " + menu.folder.string());
    for (const WorldEntry& world : menu.worlds) world_row(menu, world, wish);
}

void delete_world_page(Menu& menu, const WorldFile* open) {
    const MenuWindow window("Delete this world?", 32.0f);
    menu_text(fmt::format("\"{}\" and all that was built in it will be gone for ever.", menu.chosen.stem().string()));
    menu_problem(menu.problem);
    if (menu_button("Keep it")) return show_worlds(menu, open);
    ImGui::SetItemDefaultFocus();
    if (!menu_button("Delete it")) return;
    try {
        delete_world(menu.chosen);
        show_worlds(menu, open);
    } catch (const std::exception& error) {
        menu.problem = error.what();
    }
}

void opening_world_page(const Menu& menu) {
    const MenuWindow window("Worlds", 28.0f);
    menu_text(fmt::format("Opening \"{}\" ...", menu.chosen.stem().string()));
}

}  // namespace sl
