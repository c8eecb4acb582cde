// SPDX-License-Identifier: MIT
#pragma once

#include "editor/see/probed_point.h"
#include "engine/render/trace/transport_world.h"

namespace sl {

/// What one light brings straight to a point.
struct LightShare {
    Entity light;
    vec3 irradiance{0.0f};  ///< lux, as if nothing stood in between
    dvec3 from{0.0};        ///< where it comes from, in the world; sunlight from far away
    bool blocked = false;   ///< something does
};

/// Of all lights that shine on the point's side, the strongest first. With a traced scene, shadows are found by rays.
std::vector<LightShare> light_shares(const RenderScene& scene, const ProbedPoint& point, const TransportWorld* world);
/// What arrives of them.
vec3 arriving(const std::vector<LightShare>& shares);

}  // namespace sl
