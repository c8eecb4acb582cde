// SPDX-License-Identifier: MIT
#pragma once

#include <unordered_map>

#include "engine/render/trace/trace_scene.h"

namespace sl {

/// A point on a glowing triangle, drawn by what it gives out.
struct EmitterSample {
    vec3 position;
    TriangleHit hit;
    float density = 0.0f;  ///< per m²
};

/// A straight way from a surface point to a glowing one.
struct EmitterPath {
    vec3 direction;     ///< unit, from the surface
    vec3 radiance;      ///< nit, that leaves the emitter this way
    float density = 0;  ///< per sr
    Ray ray;            ///< what it meets is in the way
};

/// All glowing triangles of a scene. Triangles are drawn in proportion to area times radiance (without textures).
class Emitters {
  public:
    explicit Emitters(const TraceScene& scene);

    /// The ball around a glowing triangle.
    struct Ball {
        vec3 place;
        float radius;
        vec3 normal;
        float power;  ///< radiance times area, nit m², summed over the colours

        bool operator==(const Ball&) const = default;
    };

    bool empty() const { return triangles_.empty(); }
    std::vector<Ball> balls() const;
    /// xi in [0, 1)²; not when empty.
    EmitterSample sample(vec2 xi) const;
    /// Density, per m², with which `sample` draws a point of this triangle; 0 for one that does not glow.
    float density(const TriangleHit& hit) const;

    /// A way to a drawn point, blocked or not; none where it faces away or lies behind the surface. Not when empty.
    std::optional<EmitterPath> path_from(const TraceScene& scene, const SurfacePoint& point, vec2 xi) const;
    /// Density, per sr, with which `path_from` takes the way along which a ray of unit direction met `point`.
    float path_density(const TriangleHit& hit, const SurfacePoint& point, vec3 direction) const;

  private:
    struct Glowing {
        std::array<vec3, 3> corners;
        std::uint32_t draw, triangle;
        float density;       ///< per m²
        float power;         ///< nit m²
        float share_before;  ///< sum of the shares of those before it
    };
    static std::uint64_t key(std::uint32_t draw, std::uint32_t triangle) { return (std::uint64_t{draw} << 32) | triangle; }

    std::vector<Glowing> triangles_;
    std::unordered_map<std::uint64_t, float> densities_;
};

}  // namespace sl
