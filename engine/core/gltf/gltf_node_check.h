// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/core/gltf/gltf_node_tree.h"
#include "engine/core/gltf/gltf_view_use.h"

namespace sl {

/// Transforms, meshes and weights of nodes; roots of scenes.
void check_gltf_nodes(const nlohmann::json& document, const GltfNodeTree& tree, GltfFaults& faults);

/// Joints with a common root, inverse bind matrices. Without a fatal fault there is a matrix for each joint.
void check_gltf_skins(const nlohmann::json& document, const GltfLayout& layout, const GltfNodeTree& tree,
                      GltfViewUses& uses, GltfFaults& faults);

/// Planes of cameras, cones of lights.
void check_gltf_cameras_and_lights(const nlohmann::json& document, GltfFaults& faults);

}  // namespace sl
