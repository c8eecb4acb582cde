// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
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
    /// What `value` divides by.
    double one() const;
    /// Calls visit(element, component, number as stored) for all, in that order; several times as fast as asking for each.
    template <class Visit>
    void each_stored(Visit&& visit) const;

  private:
    GltfElements() = default;
    void replace(const GltfLayout& layout, Buffers buffers, const GltfAccessor& accessor);
    template <class Number, class Visit>
    void each_of(Visit&& visit) const;

    std::vector<std::byte> copy_;  ///< where elements are replaced
    std::span<const std::byte> bytes_;
    std::size_t stride_ = 0, count_ = 0;
    GltfFormat format_;
    std::array<std::uint8_t, 16> component_at_{};  ///< its first byte within an element
};

/// A number as stored, which may lie anywhere.
double read_gltf_number(const std::byte* bytes, GltfComponent component);

template <class Number, class Visit>
void GltfElements::each_of(Visit&& visit) const {
    const std::size_t components = format_.components();
    for (std::size_t i = 0; i < count_; ++i) {
        const std::byte* element = bytes_.data() + i * stride_;
        for (std::size_t k = 0; k < components; ++k) {
            Number number;
            std::memcpy(&number, element + component_at_[k], sizeof number);
            visit(i, k, static_cast<double>(number));
        }
    }
}

template <class Visit>
void GltfElements::each_stored(Visit&& visit) const {
    switch (format_.component) {
        case GltfComponent::int8: return each_of<std::int8_t>(visit);
        case GltfComponent::uint8: return each_of<std::uint8_t>(visit);
        case GltfComponent::int16: return each_of<std::int16_t>(visit);
        case GltfComponent::uint16: return each_of<std::uint16_t>(visit);
        case GltfComponent::uint32: return each_of<std::uint32_t>(visit);
        case GltfComponent::float32: return each_of<float>(visit);
    }
}

}  // namespace sl
