// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/model/model.h"

namespace tinygltf {
class Model;
}

namespace sl {

/// Scenes, nodes, lights, cameras, skins and animations of a glTF file, with parents before their children. Throws Error for
/// what refers to nothing, or a node that stands above itself.
void read_gltf_nodes(const tinygltf::Model& file, Model& model);

}  // namespace sl
