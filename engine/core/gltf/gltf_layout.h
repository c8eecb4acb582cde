// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace sl {

/// Type of one number of an accessor, by the number that stands for it in a file.
enum class GltfComponent : std::uint16_t { int8 = 5120, uint8, int16, uint16, uint32 = 5125, float32 };

/// Its size in a buffer.
std::size_t gltf_component_bytes(GltfComponent component);

/// What one element of an accessor is.
struct GltfFormat {
    GltfComponent component = GltfComponent::float32;
    std::uint8_t columns = 0;  ///< 0: the type or the component type is unknown, nothing can be read
    std::uint8_t rows = 0;
    bool is_normalized = false;

    bool is_known() const { return columns > 0; }
    bool is_matrix() const { return columns > 1; }
    std::size_t components() const { return std::size_t{columns} * rows; }
    /// Columns of a matrix begin at multiples of 4 bytes.
    std::size_t column_bytes() const;
    /// Without the padding after the last column.
    std::size_t element_bytes() const;
    /// From one element to the next where they are packed.
    std::size_t packed_bytes() const;

    bool operator==(const GltfFormat&) const = default;
};

/// "VEC3 of float32", "VEC4 of normalized uint8".
std::string gltf_format_text(const GltfFormat& format);

/// A buffer view: bytes in a row of one buffer.
struct GltfView {
    std::size_t buffer = 0;
    std::size_t offset = 0;
    std::size_t length = 0;
    std::size_t stride = 0;  ///< 0: packed
    std::size_t target = 0;  ///< 0: not told
};

/// Elements that replace others.
struct GltfSparse {
    std::size_t count = 0;
    std::size_t index_view = 0;
    std::size_t index_offset = 0;
    GltfComponent index_component = GltfComponent::uint32;
    std::size_t value_view = 0;
    std::size_t value_offset = 0;
};

/// An accessor: elements of one format, in a view or sparse.
struct GltfAccessor {
    GltfFormat format;
    std::size_t count = 0;
    std::optional<std::size_t> view;  ///< nothing: all zeros
    std::size_t offset = 0;
    std::size_t stride = 0;  ///< from one element to the next, never 0 where the format is known
    std::optional<GltfSparse> sparse;
    bool has_bounds = false;
};

/// Where the numbers of a document lie. For a document whose structure has been checked.
struct GltfLayout {
    std::vector<std::size_t> buffer_lengths;
    std::vector<GltfView> views;
    std::vector<GltfAccessor> accessors;
};

/// Of a document whose structure has been checked.
GltfLayout read_gltf_layout(const nlohmann::json& document);

inline constexpr std::size_t gltf_vertex_target = 34962;
inline constexpr std::size_t gltf_index_target = 34963;

}  // namespace sl
