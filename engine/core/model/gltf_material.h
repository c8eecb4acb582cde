// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/model/model.h"

namespace tinygltf {
class Model;
}

namespace sl {

/// All materials of a glTF file, with KHR_materials_emissive_strength, _ior, _specular and KHR_texture_transform. What of them is not
/// drawn, `warnings` tells.
std::vector<ModelMaterial> gltf_materials(const tinygltf::Model& file, std::vector<std::string>& warnings);

}  // namespace sl
