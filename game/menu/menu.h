// SPDX-License-Identifier: MIT
#pragma once

#include "game/saving/world_list.h"
#include "game/session.h"
#include "game/settings/user_settings.h"

namespace sl {

enum class MenuPage { closed, pause, worlds, new_world, delete_world, opening_world, settings, keys, press_key, help };

/// The menu over the game, and what it remembers between frames. While it is open the game stands still.
struct Menu {
    MenuPage page = MenuPage::closed;
    std::string problem;  ///< what the last thing that was tried has failed of; until another page is shown

    std::filesystem::path folder;  ///< where the worlds lie
    std::vector<WorldEntry> worlds;
    std::vector<SceneListing> scenes;
    std::string new_name;
    std::size_t new_scene = 0;
    std::filesystem::path chosen;  ///< the world that is to be deleted, or that is being opened
    Action rebound = Action::forward;  ///< the action that waits for its key, or got one last

    bool is_open() const { return page != MenuPage::closed; }
};

/// A world that is to be played; without a scene it is there and names its own.
struct WorldChoice {
    std::filesystem::path path;
    std::string scene;
};

/// What a player has asked the game for in a frame.
struct MenuWish {
    bool quit = false;
    std::optional<WorldChoice> world;
};

/// Opens the menu, goes back a page, or puts an action on the key that was pressed. Escape does not go back where a widget has
/// use for it. `input` as the window tells it, before widgets take their part; before the frame's widgets.
void menu_keys(Menu& menu, const Input& input, UserSettings& settings);

/// The page before this one; closed after the first.
void go_back(Menu& menu);
void show_page(Menu& menu, MenuPage page);
/// Shows the worlds as they are on disk now.
void show_worlds(Menu& menu, const WorldFile* open);

/// Draws the page; changes `settings` as the player does. `open`: the world that is played, or null. Between begin and draw of an
/// ImguiLayer.
MenuWish draw_menu(Menu& menu, UserSettings& settings, const WorldFile* open);

}  // namespace sl
