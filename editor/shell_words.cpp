// SPDX-License-Identifier: MIT
#include "editor/shell_words.h"

#include <string_view>

namespace sl {

namespace {

bool is_plain(std::string_view word) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./:=,+@%";
    return !word.empty() && word.find_first_not_of(plain) == std::string_view::npos;
}

std::string shell_word(std::string_view word) {
    if (is_plain(word)) return std::string(word);
    std::string text = "'";
    for (const char c : word) {
        // Nothing but its end is special inside single quotes.
        text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return text + "'";
}

}  // namespace

std::string shell_line(std::span<const std::string> words) {
    std::string line;
    for (const std::string& word : words) line += (line.empty() ? "" : " ") + shell_word(word);
    return line;
}

}  // namespace sl
