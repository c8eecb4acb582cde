// SPDX-License-Identifier: MIT
#pragma once

#include "editor/see/probed_point.h"
#include "engine/core/image.h"

namespace sl {

/// What one texel of a reflective shadow map brings to a point.
struct TexelShare {
    dvec3 position{0.0};    ///< in the world
    vec3 irradiance{0.0f};  ///< lux
};

/// One light's map, as passes/rsm.frag writes it.
struct RsmLayer {
    Image position;  ///< xyz: m, relative to the scene's origin; w: patch area, m²
    Image flux;      ///< rgb: lumen; w: packed normal
};

/// What all texels bring to a point, each as a disc, as the gathers of the RSM methods take them.
struct TexelShares {
    std::vector<TexelShare> strongest;  ///< first the strongest
    vec3 sum{0.0f};                     ///< of all texels, lux
};
TexelShares texel_shares(const std::vector<RsmLayer>& layers, const ProbedPoint& point, const dvec3& origin, std::size_t most);

}  // namespace sl
