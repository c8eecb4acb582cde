// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace sl {

/// What a material asks of the meshes that wear it.
struct GltfMaterialNeeds {
    std::size_t texcoord_sets = 0;
    bool has_tangent_space = true;  ///< false: the mesh must bring one
};

/// For each material of a document whose structure has been checked.
std::vector<GltfMaterialNeeds> gltf_material_needs(const nlohmann::json& document);

}  // namespace sl
