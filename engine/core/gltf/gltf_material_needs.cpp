// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_material_needs.h"

#include <algorithm>

#include "engine/core/gltf/gltf_extensions.h"
#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

namespace {

/// Sets that the textures directly in an object ask for.
std::size_t sets_of(const json& object) {
    constexpr std::string_view ending = "Texture";
    std::size_t sets = 0;
    for (const auto& [key, info] : object.items()) {
        if (!key.ends_with(ending) || !info.is_object()) continue;
        std::size_t set = gltf_whole_at(info, "texCoord", 0);
        if (const json* transform = gltf_extension(info, "KHR_texture_transform")) {
            set = gltf_whole_at(*transform, "texCoord", set);
        }
        sets = std::max(sets, set + 1);
    }
    return sets;
}

GltfMaterialNeeds needs_of(const json& material) {
    GltfMaterialNeeds needs{.texcoord_sets =
                                std::max(sets_of(material), sets_of(gltf_part(material, "pbrMetallicRoughness")))};
    for (const auto& [name, content] : gltf_part(material, "extensions").items()) {
        if (is_known_gltf_extension(name)) needs.texcoord_sets = std::max(needs.texcoord_sets, sets_of(content));
    }
    const json* clearcoat = gltf_extension(material, "KHR_materials_clearcoat");
    const bool uses_tangents = gltf_extension(material, "KHR_materials_anisotropy") ||
                               (clearcoat && clearcoat->contains("clearcoatNormalTexture"));
    // Its coordinates give a tangent space.
    needs.has_tangent_space = !uses_tangents || material.contains("normalTexture");
    return needs;
}

}  // namespace

std::vector<GltfMaterialNeeds> gltf_material_needs(const json& document) {
    std::vector<GltfMaterialNeeds> needs;
    for (const json& material : gltf_list(document, "materials")) needs.push_back(needs_of(material));
    return needs;
}

}  // namespace sl
