// SPDX-License-Identifier: MIT
#pragma once

#include <imgui.h>

#include <string>

namespace sl {

/// A page's window in the middle of the screen, as high as what is in it and never larger than the screen: from construction to
/// destruction. `width` in heights of the font.
class MenuWindow {
  public:
    MenuWindow(const char* title, float width);
    ~MenuWindow();
    MenuWindow(const MenuWindow&) = delete;
    MenuWindow& operator=(const MenuWindow&) = delete;
};

/// As wide as the window.
bool menu_button(const char* label);

/// Lines as wide as the window.
void menu_text(const std::string& text);
/// What went wrong; nothing where the text is empty.
void menu_problem(const std::string& text);

/// The head of a part of a page.
void menu_heading(const char* text);

}  // namespace sl
