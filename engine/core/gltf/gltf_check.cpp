// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_check.h"

#include "engine/core/gltf/gltf_data_check.h"
#include "engine/core/gltf/gltf_image_check.h"
#include "engine/core/gltf/gltf_meaning.h"
#include "engine/core/gltf/gltf_structure.h"
#include "engine/core/gltf/gltf_uri.h"

namespace sl {

namespace {

/// Data are decoded by then, and their texts are larger.
void forget_data_texts(nlohmann::json& document) {
    for (const char* list : {"buffers", "images"}) {
        const auto found = document.find(list);
        if (found == document.end()) continue;
        for (nlohmann::json& entry : *found) {
            const auto uri = entry.find("uri");
            if (uri != entry.end() && uri->get_ref<const std::string&>().starts_with(gltf_data_scheme)) *uri = std::string(gltf_data_scheme);
        }
    }
}

}  // namespace

GltfChecked check_gltf(std::span<const std::byte> bytes, const GltfLoad& load,
                       std::span<const std::string_view> supported) {
    GltfChecked checked;
    GltfFaults& faults = checked.faults;
    checked.file = read_gltf_file(bytes, faults);
    if (faults.has_fatal()) return checked;
    const nlohmann::json& document = checked.file.json;
    check_gltf_structure(document, faults, supported);
    if (faults.has_fatal()) return checked;
    checked.layout = read_gltf_layout(document);
    check_gltf_meaning(document, checked.layout, faults);
    if (faults.has_fatal()) return checked;
    checked.resources.load(document, {.is_container = checked.file.is_container, .binary = checked.file.binary}, load, faults);
    forget_data_texts(checked.file.json);
    if (faults.has_fatal()) return checked;
    const auto& buffers = checked.resources.buffers();
    check_gltf_data(document, checked.layout, buffers, checked.resources.stored_bytes(), faults);
    check_gltf_images(document, checked.resources.images(), faults);
    return checked;
}

}  // namespace sl
