// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace sl {

/// Values of a document. All but `gltf_whole_number` are for one whose structure has been checked: they trust its types.

/// What others reckon with in 64 bits: 0 to 2^53 - 1, "1.0" being 1 as well.
inline constexpr std::uint64_t most_gltf_whole = (std::uint64_t{1} << 53) - 1;
/// None for fractions, negative numbers and what a double cannot tell from its neighbours; 3.0 is whole.
std::optional<std::uint64_t> gltf_whole_number(const nlohmann::json& value);

/// The array at a key; an empty one where there is none.
const nlohmann::json& gltf_list(const nlohmann::json& object, std::string_view key);
/// The object at a key; an empty one where there is none.
const nlohmann::json& gltf_part(const nlohmann::json& object, std::string_view key);
/// The content of an extension; null where there is none.
const nlohmann::json* gltf_extension(const nlohmann::json& object, std::string_view name);

/// The whole number at a key.
std::optional<std::size_t> gltf_find_whole(const nlohmann::json& object, std::string_view key);
/// Of a checked object, as are those below; `otherwise` where the key is not there.
std::size_t gltf_whole_at(const nlohmann::json& object, std::string_view key, std::size_t otherwise);
/// The number at a key.
double gltf_number_at(const nlohmann::json& object, std::string_view key, double otherwise);
/// The text at a key; empty where there is none. Lives as long as the object.
std::string_view gltf_text_at(const nlohmann::json& object, std::string_view key);
/// Whether the key is there and true.
bool gltf_flag_at(const nlohmann::json& object, std::string_view key);

}  // namespace sl
