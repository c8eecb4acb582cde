// SPDX-License-Identifier: MIT
#include "engine/core/key_names.h"

#include <algorithm>
#include <cctype>

namespace sl {

namespace {

// clang-format off
constexpr std::array<std::string_view, key_count> names{
    "a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m", "n", "o", "p", "q", "r", "s", "t", "u", "v", "w", "x", "y", "z",
    "0", "1", "2", "3", "4", "5", "6", "7", "8", "9",
    "f1", "f2", "f3", "f4", "f5", "f6", "f7", "f8", "f9", "f10", "f11", "f12",
    "space", "enter", "escape", "tab", "left", "right", "up", "down", "plus", "minus", "left_bracket", "right_bracket",
    "comma", "period", "slash", "backslash", "semicolon", "apostrophe", "grave_accent",
    "backspace", "insert", "home", "end", "page_up", "page_down",
    "alt", "shift", "control"};
// clang-format on
static_assert(!names.back().empty());

/// Keys that people know by what is printed on them.
constexpr std::pair<Key, std::string_view> symbols[] = {{Key::plus, "+"},      {Key::minus, "-"},        {Key::left_bracket, "["}, {Key::right_bracket, "]"},
                                                        {Key::comma, ","},     {Key::period, "."},       {Key::slash, "/"},        {Key::backslash, "\\"},
                                                        {Key::semicolon, ";"}, {Key::apostrophe, "'"}, {Key::grave_accent, "`"}};

}  // namespace

std::span<const std::string_view> key_names() { return names; }

std::string key_label(Key key) {
    const auto symbol = std::ranges::find(symbols, key, &std::pair<Key, std::string_view>::first);
    if (symbol != std::end(symbols)) return std::string(symbol->second);
    std::string label(key_name(key));
    std::ranges::replace(label, '_', ' ');
    label.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(label.front())));
    return label;
}

}  // namespace sl
