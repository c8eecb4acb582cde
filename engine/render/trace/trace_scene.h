// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "engine/render/scene/render_scene.h"
#include "shared/brdf.h"
#include "shared/scene.h"

namespace sl {

/// A ray; `direction` need not be unit, distances are in its lengths.
struct Ray {
    vec3 origin;
    vec3 direction;
    float nearest = 0.0f;
    float farthest = std::numeric_limits<float>::infinity();
};

/// Where a ray met a triangle.
struct TriangleHit {
    std::uint32_t draw = 0, triangle = 0;
    float u = 0.0f, v = 0.0f;  ///< weights of the second and third corner
    float distance = 0.0f;     ///< in lengths of the ray's direction
    bool front = true;         ///< the ray came from the side that the triangle faces
};

/// All that light transport needs to know of a point on a surface.
struct SurfacePoint {
    vec3 position;
    vec3 face;           ///< unit normal of the triangle
    Surface surface;     ///< with the shading normal
    vec3 emission;       ///< nit, of the front
    float error = 0.0f;  ///< m: bound of the position's rounding error
    vec3 unlit{0.0f};    ///< nit that the camera sees, and light does not
    vec3 vertex_normal{0.0f};  ///< what a normal texture has tilted the normal from; zero where there is none

    vec3 normal() const { return vec3(surface.normal); }
    /// Whether light from a direction is reflected. As in most renderers, what a normal texture leans towards a direction from
    /// behind the surface stays dark, in the rasterizer as well: nothing shines through, and energy is lost rather than made.
    bool faces(vec3 direction) const {
        return glm::dot(normal(), direction) > 0.0f && (vertex_normal == vec3(0.0f) || glm::dot(vertex_normal, direction) > 0.0f);
    }
    /// Start of a ray that leaves towards `direction`: moved off the triangle by more than the rounding error, on the
    /// right side. Relative to the coordinates' size, so that no length has to be guessed.
    vec3 origin_towards(vec3 direction) const { return position + face * (glm::dot(direction, face) < 0.0f ? -error : error); }
};

/// Whether surfaces have the normals that normal textures ask for, or those of their vertices.
enum class Relief { tilted, flat };

/// A render scene's triangles under Embree (Wald et al. 2014), with their materials. Reads meshes and textures of the
/// RenderScene only while it is built. All queries may run on any number of threads.
class TraceScene {
  public:
    /// Throws Error when Embree cannot start or has no memory.
    explicit TraceScene(const RenderScene& scene, Relief relief = Relief::tilted);
    ~TraceScene();
    TraceScene(const TraceScene&) = delete;
    TraceScene& operator=(const TraceScene&) = delete;

    /// Goes on as another scene; costs what differs between the draws of both. Draws that stay keep their numbers. Not while
    /// queries run.
    void update(const RenderScene& scene);

    /// Changes all positions by `offset`, m. Not while queries run.
    void move(vec3 offset);

    /// The nearest hit, whichever side it faces.
    std::optional<TriangleHit> intersect(const Ray& ray) const;
    /// The nearest hit on a front: surfaces are invisible from behind, as rasterization culls them. Its distance counts
    /// from the last surface that was passed.
    std::optional<TriangleHit> intersect_front(Ray ray) const;
    bool occluded(const Ray& ray) const;

    SurfacePoint surface_at(const TriangleHit& hit) const;

    /// Corners of a triangle in world space; counter-clockwise seen from its front.
    std::array<vec3, 3> corners(std::uint32_t draw, std::uint32_t triangle) const;
    /// Whether any triangle of a draw may glow.
    bool glows(std::uint32_t draw) const;
    /// Radiance that the front of a triangle gives out, without its texture; zero for most.
    vec3 plain_emission(std::uint32_t draw, std::uint32_t triangle) const;
    /// One more than the largest number of a draw; some numbers may be those of none.
    std::uint32_t draw_count() const;
    std::uint32_t triangle_count(std::uint32_t draw) const;
    std::uint64_t triangles() const;
    Bounds bounds() const;
    /// Of everything that is traced: geometry, materials, textures.
    std::uint64_t content_hash() const;

  private:
    struct Data;
    std::unique_ptr<Data> data_;
};

}  // namespace sl
