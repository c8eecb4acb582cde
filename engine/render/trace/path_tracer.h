// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/trace/path_walk.h"
#include "shared/frame.h"

namespace sl {

/// The first surface behind a pixel's centre.
struct FirstSurface {
    vec3 albedo{0.0f}, normal{0.0f}, position{0.0f};
    float depth = 0.0f;  ///< reversed like the rasterizer's: near / distance along the view axis; 0 is the background
};

/// Path tracing with next-event estimation (Kajiya 1986; Veach 1997): at each vertex one shadow ray to a punctual light
/// drawn by what it would contribute unblocked, and one to a glowing triangle, combined with hitting it by the power
/// heuristic; a uniform sky is met by scattered rays alone, whose density already is its cosine. Points that punctual
/// lights shine on are found twice, by scattered rays and by rays from the lights (LightPaths), combined in the same way.
/// Unbiased but for rounding. All queries may run on any number of threads.
class PathTracer {
  public:
    /// The scene's view must be there; width and height in pixels. Throws Error when the ray tracer does not start.
    PathTracer(const RenderScene& scene, uvec2 size, const TransportSettings& settings);

    /// Pixel (0, 0) is the upper left. Samples with even and odd numbers are two independent sequences.
    PathSample sample(uvec2 pixel, std::uint32_t number) const;
    /// The same, and the rays that it traced (but for those past backs on the way from the camera), for measuring what
    /// their intersections alone cost.
    PathSample sample_recorded(uvec2 pixel, std::uint32_t number, std::vector<TracedRay>& rays) const;
    FirstSurface first_surface(uvec2 pixel) const;

    const TraceScene& scene() const { return world_.scene; }
    /// Of the scene, its lights and the view: two tracers with one hash and the same settings trace the same picture.
    std::uint64_t content_hash() const;

  private:
    Ray camera_ray(uvec2 pixel, vec2 within) const;
    PathSample trace(uvec2 pixel, std::uint32_t number, const PathRecord& record) const;

    TransportWorld world_;
    FrameParams frame_;
};

}  // namespace sl
