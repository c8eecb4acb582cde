// SPDX-License-Identifier: MIT
#include <fmt/ranges.h>

#include "engine/core/key_names.h"
#include "game/menu/menu_window.h"
#include "game/menu/pages.h"

namespace sl {

namespace {

std::string conflict_text(const KeyBindings& keys, Action action) {
    std::vector<std::string_view> names;
    for (const Action other : conflicts(keys, action)) names.push_back(action_info(other).name);
    return names.empty() ? std::string() : fmt::format("also {}", fmt::join(names, ", "));
}

void key_row(Menu& menu, const KeyBindings& keys, Action action) {
    const ActionInfo& info = action_info(action);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(info.name.data(), info.name.data() + info.name.size());
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(action));
    if (ImGui::Button(key_label(keys[action]).c_str(), ImVec2(-std::numeric_limits<float>::min(), 0.0f))) {
        show_page(menu, MenuPage::press_key);
        menu.rebound = action;
    }
    // The one that was changed last stays where the keyboard is.
    if (action == menu.rebound) ImGui::SetItemDefaultFocus();
    ImGui::PopID();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    menu_problem(conflict_text(keys, action));
}

}  // namespace

void keys_page(Menu& menu, KeyBindings& keys) {
    const MenuWindow window("Keys", 40.0f);
    if (ImGui::Button("Back")) go_back(menu);
    ImGui::SameLine();
    if (ImGui::Button("Usual keys")) keys = {};
    if (!ImGui::BeginTable("keys", 3, ImGuiTableFlags_SizingStretchProp)) return;
    ImGui::TableSetupColumn("action", ImGuiTableColumnFlags_WidthStretch, 0.35f);
    ImGui::TableSetupColumn("key", ImGuiTableColumnFlags_WidthStretch, 0.3f);
    ImGui::TableSetupColumn("conflict", ImGuiTableColumnFlags_WidthStretch, 0.35f);
    for (std::size_t i = 0; i < action_count; ++i) key_row(menu, keys, static_cast<Action>(i));
    ImGui::EndTable();
}

void press_key_page(const Menu& menu, const KeyBindings& keys) {
    const MenuWindow window("Press a key", 28.0f);
    const ActionInfo& info = action_info(menu.rebound);
    menu_text(fmt::format("{} ({})", info.name, info.help));
    menu_text(fmt::format("Press the key that is to do this. Escape keeps {}.", key_label(keys[menu.rebound])));
}

}  // namespace sl
