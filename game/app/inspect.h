// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "engine/core/mesh_data.h"

namespace sl {

/// Tell what is in a file. Throw Error.
void inspect_model(const std::filesystem::path& path);
void inspect_scene(const std::filesystem::path& path);

/// A heading with a count, and the first few of its lines.
template <class Items, class Line>
void print_part(const char* heading, const Items& items, Line&& line) {
    constexpr std::size_t most_lines = 20;
    fmt::print("{}: {}\n", heading, items.size());
    for (std::size_t i = 0; i < std::min(items.size(), most_lines); ++i) fmt::print("  {}\n", line(items[i]));
    if (items.size() > most_lines) fmt::print("  and {} more\n", items.size() - most_lines);
}

void print_bounds(const Bounds& bounds);

}  // namespace sl
