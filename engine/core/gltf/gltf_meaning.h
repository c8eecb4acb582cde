// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/core/gltf/gltf_fault.h"
#include "engine/core/gltf/gltf_layout.h"

namespace sl {

/// Meaning, without data: views within buffers, alignment, strides, formats of accessors where they are used, node
/// trees, cameras, lights, skins, animations, morph targets, attributes of meshes. For a document whose structure has
/// no fatal fault.
void check_gltf_meaning(const nlohmann::json& document, const GltfLayout& layout, GltfFaults& faults);

}  // namespace sl
