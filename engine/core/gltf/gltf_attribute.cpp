// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_attribute.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace sl {

namespace {

/// Sets of component types, the normalized ones apart.
using Components = std::uint32_t;
constexpr Components f32 = 1, i8 = 2, i8n = 4, u8 = 8, u8n = 16, i16 = 32, i16n = 64, u16 = 128, u16n = 256;
constexpr Components positive_fractions = f32 | u8n | u16n;
constexpr Components fractions = positive_fractions | i8n | i16n;

struct KindEntry {
    std::string_view name;
    bool is_numbered;
    std::uint8_t least_rows, most_rows;
    Components base, quantized;                ///< `quantized` are the additional ones
    Components target, quantized_target;       ///< in morph targets; 0: not allowed there
};

/// In the order of GltfAttributeKind.
constexpr std::array<KindEntry, gltf_attribute_kinds - 1> kinds{{
    {"POSITION", false, 3, 3, f32, i8 | i8n | u8 | u8n | i16 | i16n | u16 | u16n, f32, i8 | i8n | i16 | i16n},
    {"NORMAL", false, 3, 3, f32, i8n | i16n, f32, i8n | i16n},
    {"TANGENT", false, 4, 4, f32, i8n | i16n, f32, i8n | i16n},
    {"TEXCOORD", true, 2, 2, positive_fractions, i8 | i8n | u8 | i16 | i16n | u16, fractions, i8 | i16},
    {"COLOR", true, 3, 4, positive_fractions, 0, fractions, 0},
    {"JOINTS", true, 4, 4, u8 | u16, 0, 0, 0},
    {"WEIGHTS", true, 4, 4, positive_fractions, 0, 0, 0},
}};

constexpr std::array<std::pair<Components, std::string_view>, 9> component_names{
    {{f32, "float32"}, {i8, "int8"}, {i8n, "normalized int8"}, {u8, "uint8"}, {u8n, "normalized uint8"}, {i16, "int16"},
     {i16n, "normalized int16"}, {u16, "uint16"}, {u16n, "normalized uint16"}}};

Components component_bit(const GltfFormat& format) {
    switch (format.component) {
        case GltfComponent::float32: return f32;
        case GltfComponent::int8: return format.is_normalized ? i8n : i8;
        case GltfComponent::uint8: return format.is_normalized ? u8n : u8;
        case GltfComponent::int16: return format.is_normalized ? i16n : i16;
        case GltfComponent::uint16: return format.is_normalized ? u16n : u16;
        case GltfComponent::uint32: return 0;
    }
    return 0;
}

}  // namespace

std::optional<GltfAttribute> read_gltf_attribute(std::string_view name) {
    if (name.starts_with('_')) return GltfAttribute{GltfAttributeKind::custom};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const KindEntry& kind = kinds[i];
        if (!name.starts_with(kind.name)) continue;
        GltfAttribute attribute{static_cast<GltfAttributeKind>(i)};
        const std::string_view rest = name.substr(kind.name.size());
        if (!kind.is_numbered) return rest.empty() ? std::optional(attribute) : std::nullopt;
        if (rest.size() < 2 || rest[0] != '_' || rest[1] < '0' || rest[1] > '9') return std::nullopt;
        if (rest[1] == '0' && rest.size() > 2) return std::nullopt;
        const auto [end, error] = std::from_chars(rest.data() + 1, rest.data() + rest.size(), attribute.set);
        return error == std::errc() && end == rest.data() + rest.size() ? std::optional(attribute) : std::nullopt;
    }
    return std::nullopt;
}

std::string gltf_attribute_format_fault(GltfAttributeKind attribute, const GltfFormat& format, GltfAttributeRules rules) {
    if (attribute == GltfAttributeKind::custom) {
        return format.component == GltfComponent::uint32 ? "anything but uint32" : "";
    }
    const KindEntry& kind = kinds[static_cast<std::size_t>(attribute)];
    // The hand of a tangent does not change.
    const bool is_short = rules.is_target && attribute == GltfAttributeKind::tangent;
    const std::uint8_t most_rows = is_short ? 3 : kind.most_rows, least_rows = is_short ? 3 : kind.least_rows;
    Components allowed = rules.is_target ? kind.target : kind.base;
    if (rules.is_quantized) allowed |= rules.is_target ? kind.quantized_target : kind.quantized;
    const bool is_vector = format.columns == 1 && format.rows >= least_rows && format.rows <= most_rows;
    if (is_vector && (component_bit(format) & allowed) != 0) return {};
    std::string text;
    for (const auto& [bit, name] : component_names) {
        if ((allowed & bit) != 0) text += fmt::format("{}{}", text.empty() ? "" : ", ", name);
    }
    if (text.empty()) return "left out of morph targets";
    return fmt::format("VEC{}{} of {}", least_rows, least_rows == most_rows ? "" : fmt::format(" or VEC{}", most_rows), text);
}

}  // namespace sl
