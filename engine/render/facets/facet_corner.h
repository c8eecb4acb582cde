// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/trace/trace_scene.h"

namespace sl {

/// Where the light of a facet's corner is gathered.
struct FacetCorner {
    SurfacePoint point;
    bool shared = false;  ///< it lies where the lattice has it, so that all facets that meet there agree on it
    bool cut = false;     ///< the surface ends or something stands in between: the facet is no good square
};

/// A point's own place on the surface, moved by `step` squares of side 2^level along the lattice and off it by the slope.
vec3 along_surface(const SurfacePoint& point, float level, vec2 step);

/// The surface close to `target`, where it goes on from `from` without a step or an obstacle; none where it does not.
std::optional<SurfacePoint> surface_near(const TraceScene& scene, const SurfacePoint& from, vec3 target, float side);

/// The corner at `lattice` (0 or 1 each) of the facet in whose square `point` lies at `within`.
FacetCorner facet_corner(const TraceScene& scene, const SurfacePoint& point, float level, vec2 within, vec2 lattice);

}  // namespace sl
