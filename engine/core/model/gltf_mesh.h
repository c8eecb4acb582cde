// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/model/model.h"

namespace tinygltf {
class Model;
struct Primitive;
}  // namespace tinygltf

namespace sl {

/// The triangles of one primitive of a glTF file: lists, strips and fans, indexed or not. Normals that are absent are made flat, as the format asks for.
/// Nothing where it is points or lines, which `warnings` tells. Throws Error that begins with `where` for what cannot be drawn.
std::optional<ModelPrimitive> gltf_primitive(const tinygltf::Model& file, const tinygltf::Primitive& primitive, const Model& model, const std::string& where,
                                             std::vector<std::string>& warnings);

}  // namespace sl
