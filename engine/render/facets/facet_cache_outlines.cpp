// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "engine/render/facets/facet_cache.h"

namespace sl {

std::vector<FacetOutline> FacetCache::outlines_near(vec3 place, std::size_t most) const {
    struct Near {
        const Facet* facet;
        float distance;
    };
    std::vector<Near> nearest;
    const float side = facet_side_over_distance(seen_, Facets{.spacing = spacing_});
    for (const auto& [name, facet] : facets_) {
        // Some wait at coarser and finer levels for pixels nearer by and farther off.
        const float wanted = facet_level(glm::length(facet.middle.position - vec3(seen_.camera_position)), side);
        const bool in_use = !facet.split && !facet.stand_in && facet.level + static_cast<float>(facet.depth) == wanted;
        const bool lit = std::ranges::all_of(facet.corners, [&](std::uint32_t corner) { return corners_[corner].lit; });
        if (in_use && lit) nearest.push_back({&facet, glm::length(facet.middle.position - place)});
    }
    const std::size_t count = std::min(most, nearest.size());
    std::ranges::partial_sort(nearest, nearest.begin() + static_cast<std::ptrdiff_t>(count), {}, &Near::distance);
    std::vector<FacetOutline> result(count);
    for (std::size_t i = 0; i < count; ++i) {
        // Of the facet's own order, in which x runs first, to one that goes round.
        constexpr std::array<std::size_t, 4> round{0, 1, 3, 2};
        for (std::size_t at = 0; at < 4; ++at) {
            const Corner& corner = corners_[nearest[i].facet->corners[round[at]]];
            result[i].corners[at] = corner.at.point.position;
            result[i].irradiance += 0.25f * corner.at.irradiance;
            const auto links = static_cast<float>(std::max<std::size_t>(corner.at.by_chance.size(), 1));
            result[i].noise = std::max(result[i].noise, std::sqrt(corner.spread / links));
        }
    }
    return result;
}

}  // namespace sl
