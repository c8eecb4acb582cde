// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/core/gltf/gltf_view_use.h"

namespace sl {

/// Attributes, indices and morph targets of meshes, and what their materials ask of them. Without a fatal fault every
/// attribute that has a name of the format has a format that it may have, and as many elements as the others.
void check_gltf_meshes(const nlohmann::json& document, const GltfLayout& layout, GltfViewUses& uses, GltfFaults& faults);

}  // namespace sl
