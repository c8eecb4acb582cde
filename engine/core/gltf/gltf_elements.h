// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/gltf/gltf_layout.h"

namespace sl {

/// The elements of one accessor, sparse ones in their places.
class GltfElements {
  public:
    using Buffers = std::span<const std::span<const std::byte>>;

    GltfElements(const GltfElements&) = delete;
    GltfElements& operator=(const GltfElements&) = delete;
    GltfElements(GltfElements&&) = default;
    GltfElements& operator=(GltfElements&&) = default;

    /// Nothing where there are no data: the format is unknown, a buffer is empty, or all elements are zero. For a layout
    /// without fatal faults. Indices of replaced elements that lead nowhere are left out.
    static std::optional<GltfElements> read(const GltfLayout& layout, Buffers buffers, std::size_t accessor);

    std::size_t count() const { return count_; }
    std::size_t components() const { return format_.components(); }
    /// As stored. For a matrix, components go column by column.
    double stored(std::size_t element, std::size_t component) const;
    /// Normalized whole numbers as the fractions that they stand for.
    double value(std::size_t element, std::size_t component) const;

  private:
    GltfElements() = default;
    void replace(const GltfLayout& layout, Buffers buffers, const GltfAccessor& accessor);

    std::vector<std::byte> copy_;  ///< where elements are replaced
    std::span<const std::byte> bytes_;
    std::size_t stride_ = 0, count_ = 0;
    GltfFormat format_;
};

/// A number as stored, which may lie anywhere.
double read_gltf_number(const std::byte* bytes, GltfComponent component);

}  // namespace sl
