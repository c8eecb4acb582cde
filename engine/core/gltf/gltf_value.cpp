// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_value.h"

#include <cmath>

namespace sl {

using nlohmann::json;

std::optional<std::uint64_t> gltf_whole_number(const json& value) {
    if (!value.is_number()) return std::nullopt;
    if (value.is_number_unsigned()) {
        const auto whole = value.get<std::uint64_t>();
        return whole <= most_gltf_whole ? std::optional(whole) : std::nullopt;
    }
    const double number = value.get<double>();
    if (!(number >= 0.0) || number > static_cast<double>(most_gltf_whole) || std::trunc(number) != number) return std::nullopt;
    return static_cast<std::uint64_t>(number);
}

const json& gltf_list(const json& object, std::string_view key) {
    static const json none = json::array();
    const auto found = object.find(key);
    return found == object.end() ? none : *found;
}

const json& gltf_part(const json& object, std::string_view key) {
    static const json none = json::object();
    const auto found = object.find(key);
    return found == object.end() ? none : *found;
}

const json* gltf_extension(const json& object, std::string_view name) {
    const json& extensions = gltf_part(object, "extensions");
    const auto found = extensions.find(name);
    return found == extensions.end() ? nullptr : &*found;
}

std::optional<std::size_t> gltf_find_whole(const json& object, std::string_view key) {
    const auto found = object.find(key);
    return found == object.end() ? std::nullopt : gltf_whole_number(*found);
}

std::size_t gltf_whole_at(const json& object, std::string_view key, std::size_t otherwise) {
    return gltf_find_whole(object, key).value_or(otherwise);
}

double gltf_number_at(const json& object, std::string_view key, double otherwise) {
    const auto found = object.find(key);
    return found == object.end() ? otherwise : found->get<double>();
}

std::string_view gltf_text_at(const json& object, std::string_view key) {
    const auto found = object.find(key);
    return found == object.end() ? std::string_view() : found->get_ref<const std::string&>();
}

bool gltf_flag_at(const json& object, std::string_view key) {
    const auto found = object.find(key);
    return found != object.end() && found->get<bool>();
}

}  // namespace sl
