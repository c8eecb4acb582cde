// SPDX-License-Identifier: MIT
#include "game/menu/menu_window.h"
#include "game/menu/pages.h"

namespace sl {

void pause_page(Menu& menu, const WorldFile* open, MenuWish& wish) {
    const MenuWindow window("Paused", 20.0f);
    if (menu_button("Resume")) go_back(menu);
    if (menu_button("Worlds")) show_worlds(menu, open);
    if (menu_button("Settings")) show_page(menu, MenuPage::settings);
    if (menu_button("Help")) show_page(menu, MenuPage::help);
    if (menu_button("Quit")) wish.quit = true;
}

}  // namespace sl
