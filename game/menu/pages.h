// SPDX-License-Identifier: MIT
#pragma once

#include "game/menu/menu.h"

namespace sl {

// One function per page of the menu: each draws its window and does what the player asks in it.

void pause_page(Menu& menu, const WorldFile* open, MenuWish& wish);
void worlds_page(Menu& menu, MenuWish& wish);
void new_world_page(Menu& menu, MenuWish& wish);
void delete_world_page(Menu& menu, const WorldFile* open);
void opening_world_page(const Menu& menu);
void settings_page(Menu& menu, UserSettings& settings);
void keys_page(Menu& menu, KeyBindings& keys);
void press_key_page(const Menu& menu, const KeyBindings& keys);
void help_page(Menu& menu, const KeyBindings& keys);

}  // namespace sl
