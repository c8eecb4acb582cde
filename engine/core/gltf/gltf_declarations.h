// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

#include "engine/core/gltf/gltf_fault.h"

namespace sl {

/// What a document, which is an object, says about itself: its version, and the extensions that it uses and needs.
/// An extension that is required must be one of `supported`; nothing given stands for all whose properties are known.
void check_gltf_declarations(const nlohmann::json& document, GltfFaults& faults,
                             std::span<const std::string_view> supported);

}  // namespace sl
