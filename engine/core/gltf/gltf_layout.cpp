// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

namespace {

struct TypeEntry {
    std::string_view name;
    std::uint8_t columns, rows;
};
constexpr std::array types{TypeEntry{"SCALAR", 1, 1}, TypeEntry{"VEC2", 1, 2}, TypeEntry{"VEC3", 1, 3},
                           TypeEntry{"VEC4", 1, 4},   TypeEntry{"MAT2", 2, 2}, TypeEntry{"MAT3", 3, 3},
                           TypeEntry{"MAT4", 4, 4}};

constexpr std::size_t column_alignment = 4;

std::string_view component_name(GltfComponent component) {
    switch (component) {
        case GltfComponent::int8: return "int8";
        case GltfComponent::uint8: return "uint8";
        case GltfComponent::int16: return "int16";
        case GltfComponent::uint16: return "uint16";
        case GltfComponent::uint32: return "uint32";
        case GltfComponent::float32: return "float32";
    }
    return "";
}

std::optional<GltfComponent> component_of(const json& object) {
    const auto component = static_cast<GltfComponent>(std::min<std::size_t>(gltf_whole_at(object, "componentType", 0), UINT16_MAX));
    return component_name(component).empty() ? std::nullopt : std::optional(component);
}

GltfFormat format_of(const json& accessor) {
    const std::string_view name = gltf_text_at(accessor, "type");
    const auto component = component_of(accessor);
    const auto type = std::find_if(types.begin(), types.end(), [&](const TypeEntry& entry) { return entry.name == name; });
    if (!component || type == types.end()) return {};
    return {.component = *component,
            .columns = type->columns,
            .rows = type->rows,
            .is_normalized = gltf_flag_at(accessor, "normalized")};
}

GltfView view_of(const json& view) {
    return {.buffer = gltf_whole_at(view, "buffer", 0),
            .offset = gltf_whole_at(view, "byteOffset", 0),
            .length = gltf_whole_at(view, "byteLength", 0),
            .stride = gltf_whole_at(view, "byteStride", 0),
            .target = gltf_whole_at(view, "target", 0)};
}

GltfSparse sparse_of(const json& sparse) {
    const json& indices = gltf_part(sparse, "indices");
    const json& values = gltf_part(sparse, "values");
    // Another type than these has been told; what it is read as must only stay within its view.
    const auto component = component_of(indices).value_or(GltfComponent::uint32);
    const bool is_short = component == GltfComponent::uint8 || component == GltfComponent::uint16;
    return {.count = gltf_whole_at(sparse, "count", 0),
            .index_view = gltf_whole_at(indices, "bufferView", 0),
            .index_offset = gltf_whole_at(indices, "byteOffset", 0),
            .index_component = is_short ? component : GltfComponent::uint32,
            .value_view = gltf_whole_at(values, "bufferView", 0),
            .value_offset = gltf_whole_at(values, "byteOffset", 0)};
}

GltfAccessor accessor_of(const json& accessor, const std::vector<GltfView>& views) {
    GltfAccessor read{.format = format_of(accessor),
                      .count = gltf_whole_at(accessor, "count", 0),
                      .view = gltf_find_whole(accessor, "bufferView"),
                      .offset = gltf_whole_at(accessor, "byteOffset", 0),
                      .has_bounds = accessor.contains("min") && accessor.contains("max")};
    const std::size_t stride = read.view ? views[*read.view].stride : 0;
    read.stride = stride > 0 ? stride : read.format.packed_bytes();
    if (const json& sparse = gltf_part(accessor, "sparse"); !sparse.empty()) read.sparse = sparse_of(sparse);
    return read;
}

}  // namespace

std::size_t gltf_component_bytes(GltfComponent component) {
    switch (component) {
        case GltfComponent::int8:
        case GltfComponent::uint8: return 1;
        case GltfComponent::int16:
        case GltfComponent::uint16: return 2;
        case GltfComponent::uint32:
        case GltfComponent::float32: return 4;
    }
    return 0;
}

std::size_t GltfFormat::column_bytes() const {
    const std::size_t bytes = rows * gltf_component_bytes(component);
    return is_matrix() ? (bytes + column_alignment - 1) / column_alignment * column_alignment : bytes;
}

std::size_t GltfFormat::element_bytes() const {
    return is_known() ? column_bytes() * (columns - 1u) + rows * gltf_component_bytes(component) : 0;
}

std::size_t GltfFormat::packed_bytes() const {
    return column_bytes() * columns;
}

std::string gltf_format_text(const GltfFormat& format) {
    const auto type = std::find_if(types.begin(), types.end(), [&](const TypeEntry& entry) {
        return entry.columns == format.columns && entry.rows == format.rows;
    });
    if (type == types.end()) return "an unknown type";
    return fmt::format("{} of {}{}", type->name, format.is_normalized ? "normalized " : "", component_name(format.component));
}

GltfLayout read_gltf_layout(const json& document) {
    GltfLayout layout;
    for (const json& buffer : gltf_list(document, "buffers")) {
        layout.buffer_lengths.push_back(gltf_whole_at(buffer, "byteLength", 0));
    }
    for (const json& view : gltf_list(document, "bufferViews")) layout.views.push_back(view_of(view));
    for (const json& accessor : gltf_list(document, "accessors")) {
        layout.accessors.push_back(accessor_of(accessor, layout.views));
    }
    return layout;
}

}  // namespace sl
