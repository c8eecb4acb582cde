// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace sl {

inline constexpr int deepest_json = 64;
/// Bytes of memory, without texts: more than the largest scene takes.
inline constexpr std::size_t most_json_memory = std::size_t{3} << 27;

/// Parses a text that may be anything. Throws Error "file:line:column: what is wrong" for what is no JSON, is
/// nested deeper than `deepest_json`, takes more than `most_json_memory`, holds a number too large for a double, or names a key twice in one
/// object.
nlohmann::json parse_json(std::string_view text, std::string_view file);

/// The text with its // and /* */ comments blanked out, so that places in it stay where they are. One that has no end stays,
/// and is no JSON.
std::string without_comments(std::string text);

/// For people to read and edit: a value without objects in it stands on one line where it fits, keys keep
/// their order. Bytes that are no UTF-8 become U+FFFD.
std::string json_text(const nlohmann::ordered_json& value);

}  // namespace sl
