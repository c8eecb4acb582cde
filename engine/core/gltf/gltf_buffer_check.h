// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/core/gltf/gltf_view_use.h"

namespace sl {

/// Views within buffers, accessors within views, their alignment and strides. Without a fatal fault, nothing that the
/// layout tells leads outside a buffer of the length that the document states.
void check_gltf_buffers(const nlohmann::json& document, const GltfLayout& layout, GltfViewUses& uses, GltfFaults& faults);

}  // namespace sl
