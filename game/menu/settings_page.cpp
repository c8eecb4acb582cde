// SPDX-License-Identifier: MIT
#include "editor/imgui_fields.h"
#include "engine/core/field_clamp.h"
#include "game/menu/menu_window.h"
#include "game/menu/pages.h"

namespace sl {

namespace {

template <class Section>
void edit_section(const char* name, Section& section) {
    menu_heading(name);
    const FieldTable table(name);
    if (!table) return;
    ImguiFields fields;
    visit_fields(fields, section);
    if (fields.changed()) clamp_fields(section);
}

}  // namespace

void settings_page(Menu& menu, UserSettings& settings) {
    const MenuWindow window("Settings", 40.0f);
    if (menu_button("Keys")) show_page(menu, MenuPage::keys);
    if (menu_button("Back")) go_back(menu);
    menu_problem(menu.problem);
    each_section(settings, [](const char* name, auto& section) {
        // Keys are chosen by pressing them, on a page of their own.
        if constexpr (!std::is_same_v<std::remove_cvref_t<decltype(section)>, KeyBindings>) edit_section(name, section);
    });
}

}  // namespace sl
