// SPDX-License-Identifier: MIT
#include "editor/see/texel_shares.h"

#include <algorithm>

#include "shared/rsm.h"
#include "shared/rsm_texel.h"

namespace sl {

namespace {

float strength(const TexelShare& share) { return luminance(share.irradiance); }

}  // namespace

TexelShares texel_shares(const std::vector<RsmLayer>& layers, const ProbedPoint& point, const dvec3& origin, std::size_t most) {
    const auto receiver = vec3(point.position - origin);
    TexelShares result;
    std::vector<TexelShare> shares;
    for (const RsmLayer& layer : layers) {
        for (std::size_t at = 0; at + 3 < layer.position.data.size(); at += 4) {
            const float *place = &layer.position.data[at], *flux = &layer.flux.data[at];
            const vec3 position(place[0], place[1], place[2]);
            const vec3 irradiance = texel_irradiance(vec3(flux[0], flux[1], flux[2]), position, unpack_texel_normal(flux[3]), place[3], receiver, point.normal);
            result.sum += irradiance;
            if (luminance(irradiance) > 0.0f) shares.push_back({origin + dvec3(position), irradiance});
        }
    }
    result.strongest.resize(std::min(most, shares.size()));
    std::ranges::partial_sort_copy(shares, result.strongest, std::ranges::greater{}, strength, strength);
    return result;
}

}  // namespace sl
