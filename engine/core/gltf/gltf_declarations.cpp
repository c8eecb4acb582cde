// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_declarations.h"

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <unordered_set>

#include "engine/core/closest_name.h"
#include "engine/core/gltf/gltf_extensions.h"

namespace sl {

using nlohmann::json;

namespace {

bool holds_text(const json& document, std::string_view list, std::string_view text) {
    const auto found = document.find(list);
    return found != document.end() && found->is_array() && std::find(found->begin(), found->end(), text) != found->end();
}

/// What stands in the lists of extensions, whether or not it is used.
void check_extension_lists(const json& document, std::span<const std::string_view> supported, GltfFaults& faults) {
    // Without it, a reader would take the attributes for wrong.
    constexpr std::string_view quantization = "KHR_mesh_quantization";
    if (holds_text(document, "extensionsUsed", quantization) && !holds_text(document, "extensionsRequired", quantization)) {
        faults.note("/extensionsRequired", "{} is used: it must be required too", quantization);
    }
    const auto required = document.find("extensionsRequired");
    if (required == document.end() || !required->is_array()) return;
    std::unordered_set<std::string_view> used;
    if (const auto list = document.find("extensionsUsed"); list != document.end() && list->is_array()) {
        for (const json& name : *list) {
            if (name.is_string()) used.insert(name.get_ref<const std::string&>());
        }
    }
    for (std::size_t i = 0; i < required->size() && !faults.is_done(); ++i) {
        if (!(*required)[i].is_string()) continue;
        const std::string& name = (*required)[i].get_ref<const std::string&>();
        const std::string where = fmt::format("/extensionsRequired/{}", i);
        if (!used.contains(name)) {
            faults.note(where, "'{}' is required, but does not stand in /extensionsUsed", for_message(name));
        }
        const bool is_supported = supported.empty()
                                      ? is_known_gltf_extension(name)
                                      : std::find(supported.begin(), supported.end(), name) != supported.end();
        if (!is_supported) faults.fatal(where, "the file needs '{}', which this program cannot read", for_message(name));
    }
}

/// "12.3" as {12, 3}; a number that is too large ends as the largest.
std::pair<double, double> version_numbers(const std::string& text) {
    return {std::strtod(text.substr(0, text.find('.')).c_str(), nullptr),
            std::strtod(text.substr(text.find('.') + 1).c_str(), nullptr)};
}

/// Every 2.x loads: what came after 2.0 may be ignored.
void check_version(const json& asset, GltfFaults& faults) {
    const auto text_of = [&](std::string_view key) -> const std::string* {
        const auto found = asset.find(key);
        return found == asset.end() ? nullptr : found->get_ptr<const std::string*>();
    };
    const std::string* version = text_of("version");
    const std::string* least = text_of("minVersion");
    if (!version) return;
    if (version_numbers(*version).first != 2) {
        faults.fatal("/asset/version", "is '{}'; this program reads 2.0", for_message(*version));
    }
    if (!least) return;
    if (version_numbers(*least) > version_numbers(*version)) {
        faults.fatal("/asset/minVersion", "is '{}', later than the version '{}'", for_message(*least), for_message(*version));
    }
}

}  // namespace

void check_gltf_declarations(const json& document, GltfFaults& faults, std::span<const std::string_view> supported) {
    if (const auto asset = document.find("asset"); asset != document.end() && asset->is_object()) {
        check_version(*asset, faults);
    }
    check_extension_lists(document, supported, faults);
}

}  // namespace sl
