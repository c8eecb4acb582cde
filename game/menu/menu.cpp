// SPDX-License-Identifier: MIT
#include "game/menu/menu.h"

#include <imgui.h>

#include "game/menu/pages.h"

namespace sl {

namespace {

constexpr ImU32 shade = IM_COL32(0, 0, 0, 130);

bool widget_wants_escape() {
    return ImGui::IsAnyItemActive() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
}

void bind_pressed_key(Menu& menu, const Input& input, UserSettings& settings) {
    if (input.pressed(Key::escape) || input.gamepad.pressed(GamepadButton::b)) return go_back(menu);
    for (std::size_t i = 0; i < key_count; ++i) {
        if (!input.keys_pressed[i]) continue;
        settings.keys[menu.rebound] = static_cast<Key>(i);
        return go_back(menu);
    }
}

MenuPage page_before(MenuPage page) {
    switch (page) {
        case MenuPage::closed:
        case MenuPage::pause: return MenuPage::closed;
        case MenuPage::new_world:
        case MenuPage::delete_world:
        case MenuPage::opening_world: return MenuPage::worlds;
        case MenuPage::keys: return MenuPage::settings;
        case MenuPage::press_key: return MenuPage::keys;
        case MenuPage::worlds:
        case MenuPage::settings:
        case MenuPage::help: break;
    }
    return MenuPage::pause;
}

void darken_screen() {
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    ImGui::GetBackgroundDrawList()->AddRectFilled(screen.Pos, ImVec2(screen.Pos.x + screen.Size.x, screen.Pos.y + screen.Size.y), shade);
}

}  // namespace

void show_page(Menu& menu, MenuPage page) {
    menu.page = page;
    menu.problem.clear();
}

void go_back(Menu& menu) { show_page(menu, page_before(menu.page)); }

void menu_keys(Menu& menu, const Input& input, UserSettings& settings) {
    if (menu.page == MenuPage::press_key) return bind_pressed_key(menu, input, settings);
    const bool start = input.gamepad.pressed(GamepadButton::start);
    const bool back = input.pressed(Key::escape) || (menu.is_open() && input.gamepad.pressed(GamepadButton::b));
    if ((!start && !back) || widget_wants_escape()) return;
    if (!menu.is_open()) return show_page(menu, MenuPage::pause);
    start ? show_page(menu, MenuPage::closed) : go_back(menu);
}

MenuWish draw_menu(Menu& menu, UserSettings& settings, const WorldFile* open) {
    MenuWish wish;
    if (menu.is_open()) darken_screen();
    switch (menu.page) {
        case MenuPage::closed: break;
        case MenuPage::pause: pause_page(menu, open, wish); break;
        case MenuPage::worlds: worlds_page(menu, wish); break;
        case MenuPage::new_world: new_world_page(menu, wish); break;
        case MenuPage::delete_world: delete_world_page(menu, open); break;
        case MenuPage::opening_world: opening_world_page(menu); break;
        case MenuPage::settings: settings_page(menu, settings); break;
        case MenuPage::keys: keys_page(menu, settings.keys); break;
        case MenuPage::press_key: press_key_page(menu, settings.keys); break;
        case MenuPage::help: help_page(menu, settings.keys); break;
    }
    return wish;
}

}  // namespace sl
