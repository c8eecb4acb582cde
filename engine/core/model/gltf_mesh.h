// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/model/gltf_reader.h"
#include "engine/core/model/model.h"

namespace sl {

/// The triangles of one primitive of a glTF file: lists, strips and fans, indexed or not. Normals that are absent are made flat,
/// as the format asks for, and tangents that are absent lie as the normal texture does. Nothing where it is points or lines or has no positions, which is a warning. `where` is its place in
/// the file. Throws Error for what cannot be drawn.
std::optional<ModelPrimitive> gltf_primitive(const nlohmann::json& primitive, const std::vector<ModelMaterial>& materials,
                                             const std::string& where, GltfReader& reader);

}  // namespace sl
