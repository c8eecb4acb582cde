// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/model/gltf_reader.h"
#include "engine/core/model/model.h"

namespace sl {

/// All materials of a glTF file, with KHR_materials_emissive_strength, _ior, _specular, _unlit and KHR_texture_transform. What of them is
/// not drawn is a warning.
std::vector<ModelMaterial> gltf_materials(GltfReader& reader);

}  // namespace sl
