// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string_view>

#include "engine/core/gltf/gltf_fault.h"

namespace sl {

inline constexpr int deepest_gltf = 512;

/// Parses a document, null where that is impossible. `first_byte` is where it stands in its file. Throws nothing but
/// std::bad_alloc.
nlohmann::json read_gltf_json(std::string_view text, std::size_t first_byte, GltfFaults& faults);

}  // namespace sl
