// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "engine/render/facets/facet_table.h"

namespace sl {

/// Light of corners that have few samples yet, steadied by what their neighbours say: each becomes the mean of itself and of
/// those at the other ends of its facets' sides, weighed by how sure each is. The surer a corner is, the less it listens, so
/// that nothing is left of this once light is known.
class FacetSmoothing {
  public:
    /// `irradiance` of all corners, lux, is changed in place. `variance` of each over its square; negative where there is
    /// no light yet, which then neither speaks nor listens.
    void smooth(std::span<const FacetEntry> facets, std::span<vec3> irradiance, std::span<const float> variance);

  private:
    void know_surroundings(std::span<const FacetEntry> facets, std::span<const vec3> irradiance, std::span<const float> variance);

    std::vector<vec2> around_;     ///< of each corner: luminance of it and its neighbours, and how many they are
    std::vector<float> unsure_;    ///< variance, lux²
    std::vector<vec4> sums_;       ///< weighted light, weight
};

}  // namespace sl
