// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/model/gltf_reader.h"
#include "engine/core/model/model.h"

namespace sl {

/// Scenes, nodes, lights, cameras, skins and animations of a glTF file, with parents before their children.
void read_gltf_nodes(GltfReader& reader, Model& model);

}  // namespace sl
