// SPDX-License-Identifier: MIT
#include "game/menu/keys_text.h"
#include "game/menu/menu_window.h"
#include "game/menu/pages.h"
#include "game/menu/panel_text.h"
#include "game/settings/player_input.h"

namespace sl {

namespace {

constexpr const char* about =
    "Dig, build and walk about, and see the light follow: what you break or place changes how light bounces. "
    "All that you build in a world is kept at once, whatever happens to the program. "
    "The sun moves where a scene has a day: stop it, or drag it to the hour that you want.";

void gamepad_table() {
    if (!ImGui::BeginTable("gamepad", 2, ImGuiTableFlags_SizingStretchProp)) return;
    for (const auto& [name, help] : gamepad_controls()) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(name.data(), name.data() + name.size());
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(help.data(), help.data() + help.size());
    }
    ImGui::EndTable();
}

}  // namespace

void help_page(Menu& menu, const KeyBindings& keys) {
    const MenuWindow window("Help", 44.0f);
    if (menu_button("Back")) go_back(menu);
    menu_text(about);
    menu_heading("keys");
    menu_text(keys_text(keys));
    menu_heading("panel");
    menu_text(panel_text(keys));
    menu_heading("gamepad");
    gamepad_table();
}

}  // namespace sl
