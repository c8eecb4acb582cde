// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/core/gltf/gltf_view_use.h"

namespace sl {

/// Key times, values and targets of animations. Without a fatal fault every sampler's accessors have formats and counts
/// that fit what its channels move.
void check_gltf_animations(const nlohmann::json& document, const GltfLayout& layout, GltfViewUses& uses, GltfFaults& faults);

}  // namespace sl
