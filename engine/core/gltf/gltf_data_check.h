// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/core/gltf/gltf_elements.h"
#include "engine/core/gltf/gltf_fault.h"

namespace sl {

/// Data of accessors: bounds, what is no number, indices and joints that lead outside, weights, unit vectors, key times.
/// For a document whose meaning has no fatal fault. `buffers` are as long as the document states, or empty where their
/// bytes are not known; `stored_bytes` is what they take together. Accessors that hold more together than `most_gltf_bytes`
/// of that are a fatal fault.
void check_gltf_data(const nlohmann::json& document, const GltfLayout& layout, GltfElements::Buffers buffers,
                     std::size_t stored_bytes, GltfFaults& faults);

}  // namespace sl
