// SPDX-License-Identifier: MIT
#include "engine/core/closest_name.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace sl {

namespace {

constexpr std::size_t longest_compared = 64;
constexpr std::size_t most_listed = 24;

std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0]++;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

std::string_view closest(std::string_view wrong, std::span<const std::string_view> known) {
    std::string_view best;
    std::size_t best_distance =
        wrong.size() > longest_compared ? 0 : std::max<std::size_t>(wrong.size() / 3, 1) + 1;
    for (const std::string_view name : known) {
        if (best_distance == 0 || name.size() > longest_compared) continue;
        const std::size_t distance = edit_distance(wrong, name);
        if (distance < best_distance) {
            best = name;
            best_distance = distance;
        }
    }
    return best;
}

}  // namespace

std::string no_such_name(std::string_view kind, std::string_view wrong,
                         std::span<const std::string_view> known) {
    std::string message = fmt::format("there is no {} '{}'", kind, for_message(wrong));
    if (known.empty()) return message;
    const std::string_view guess = closest(wrong, known);
    message += guess.empty() ? "." : fmt::format("; did you mean '{}'?", for_message(guess));
    const std::size_t shown = std::min(known.size(), most_listed);
    std::vector<std::string> names;
    for (std::size_t i = 0; i < shown; ++i) names.push_back(for_message(known[i]));
    message += fmt::format(" Known: {}", fmt::join(names, ", "));
    if (shown < known.size()) message += fmt::format(" and {} more", known.size() - shown);
    return message;
}

std::string no_such_name(std::string_view kind, std::string_view wrong, std::span<const std::string> known) {
    return no_such_name(kind, wrong, std::vector<std::string_view>(known.begin(), known.end()));
}

std::string for_message(std::string_view text, std::size_t most_bytes) {
    const bool cut = text.size() > most_bytes;
    std::size_t end = std::min(text.size(), most_bytes);
    const auto inside_character = [&](std::size_t byte) {
        return (static_cast<unsigned char>(text[byte]) & 0xc0) == 0x80;
    };
    while (cut && end > 0 && inside_character(end)) --end;
    std::string shown(text.substr(0, end));
    const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
    std::replace_if(shown.begin(), shown.end(), is_control, '?');
    return cut ? shown + "…" : shown;
}

}  // namespace sl
