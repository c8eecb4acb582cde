// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/render/facets/facet_name.h"

namespace sl {

/// What a shader needs to know of a facet.
struct FacetEntry {
    FacetName name;
    std::array<std::uint32_t, 4> corners;  ///< numbers of their irradiances; x runs first
    bool split;                            ///< finer ones hold more
};

/// The facets as shaders search them: open addressing, linear probing. First all names, two words each, upper half first, 0
/// where a slot is empty; then all irradiances, four words each, so that a search reads names alone.
struct FacetTable {
    std::vector<std::uint32_t> words;
    std::uint32_t slots = 0;  ///< a power of two
    std::uint32_t longest_search = 0;
    float unit = 1.0f;        ///< lux of a stored 1

    /// Makes room for these, which must have other names each. Their light is unknown until `light`.
    void place(std::span<const FacetEntry> entries);
    /// Irradiance of the same entries' corners, lux.
    void light(std::span<const FacetEntry> entries, std::span<const vec3> irradiance);

  private:
    std::vector<std::uint32_t> corners_;  ///< words of all irradiances
    std::vector<std::uint32_t> slot_;     ///< of each entry
};

}  // namespace sl
