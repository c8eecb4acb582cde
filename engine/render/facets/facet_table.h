// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "engine/render/facets/facet_name.h"

namespace sl {

/// What a shader needs to know of a facet.
struct FacetEntry {
    FacetName name;
    std::array<vec3, 4> irradiance;  ///< at its corners, lux; x runs first
    bool split;                      ///< finer ones hold more
};

/// The facets as shaders search them: open addressing, linear probing, 8 words a slot.
struct FacetTable {
    std::vector<std::uint32_t> words;
    std::uint32_t slots = 0;  ///< a power of two
    std::uint32_t longest_search = 0;
    float unit = 1.0f;        ///< lux of a stored 1

    void fill(const std::vector<FacetEntry>& entries);
};

}  // namespace sl
