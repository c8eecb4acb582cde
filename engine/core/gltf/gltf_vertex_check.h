// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/core/gltf/gltf_elements.h"
#include "engine/core/gltf/gltf_fault.h"

namespace sl {

/// Unit normals and tangents, colours, joints and weights. All of it can be shown somehow: nothing is fatal.
void check_gltf_vertices(const nlohmann::json& document, const GltfLayout& layout, GltfElements::Buffers buffers,
                         GltfFaults& faults);

}  // namespace sl
