// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>

#include "engine/core/gltf/gltf_fault.h"

namespace sl {

/// Every property's type, range, choices, length, required ones, references to what is not there, empty arrays and
/// objects, extensions (declared, required, in the right place). Without a fatal fault, what the tables of
/// gltf_schema.h name has its type, is there where it is needed, and refers to what is there. An extension that is
/// required must be one of `supported`; nothing given stands for all whose properties are known.
void check_gltf_structure(const nlohmann::json& json, GltfFaults& faults,
                          std::span<const std::string_view> supported = {});

}  // namespace sl
