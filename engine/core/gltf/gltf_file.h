// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "engine/core/gltf/gltf_fault.h"

namespace sl {

/// Text and binary part of a .gltf or .glb file.
struct GltfFile {
    nlohmann::json json;                                ///< null where there is none that could be parsed
    bool is_container = false;                          ///< .glb
    std::optional<std::span<const std::byte>> binary;   ///< the BIN chunk; points into the bytes that were read
};

/// Splits a container (.glb, told by its magic) or parses a text (.gltf). Throws nothing but std::bad_alloc.
GltfFile read_gltf_file(std::span<const std::byte> bytes, GltfFaults& faults);

}  // namespace sl
