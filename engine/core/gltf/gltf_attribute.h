// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "engine/core/gltf/gltf_layout.h"

namespace sl {

/// What a vertex attribute is, by its name ("TEXCOORD_1" is a texcoord); those that begin with _ are custom.
enum class GltfAttributeKind : std::uint8_t { position, normal, tangent, texcoord, colour, joints, weights, custom };
inline constexpr std::size_t gltf_attribute_kinds = 8;

/// What a name such as "TEXCOORD_1" says.
struct GltfAttribute {
    GltfAttributeKind kind;
    std::size_t set = 0;  ///< 1 for "TEXCOORD_1"
};

/// Nothing for a name that means nothing, such as "TEXCOORD_01". Custom ones begin with '_'.
std::optional<GltfAttribute> read_gltf_attribute(std::string_view name);

/// Where an attribute stands, as far as that decides which formats it may have.
struct GltfAttributeRules {
    bool is_target = false;     ///< of a morph target
    bool is_quantized = false;  ///< KHR_mesh_quantization allows more
};

/// Empty where an attribute may have this format, otherwise which it may have: "VEC3 of float32".
std::string gltf_attribute_format_fault(GltfAttributeKind kind, const GltfFormat& format, GltfAttributeRules rules);

}  // namespace sl
