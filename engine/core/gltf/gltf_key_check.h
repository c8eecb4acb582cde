// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/core/gltf/gltf_elements.h"
#include "engine/core/gltf/gltf_fault.h"

namespace sl {

/// Key times and rotations of animations, inverse bind matrices of skins. Nothing is fatal.
void check_gltf_keys(const nlohmann::json& document, const GltfLayout& layout, GltfElements::Buffers buffers,
                     GltfFaults& faults);

}  // namespace sl
