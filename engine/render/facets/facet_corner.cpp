// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_corner.h"

#include "engine/render/trace/directions.h"
#include "shared/facets.h"

namespace sl {

namespace {

/// How far a surface may leave its facet's plane, over the facet's side.
constexpr float most_slope = 0.12f;

/// The vector whose lattice coordinates these are.
vec3 from_axes(vec3 v, std::uint32_t axis) {
    if (axis == 0) return vec3(v.z, v.x, v.y);
    if (axis == 1) return vec3(v.y, v.z, v.x);
    return v;
}

/// Whether nothing stands right beside a point, which would darken it more than the surface around it.
bool clear_around(const TraceScene& scene, const SurfacePoint& point, float side) {
    const mat3 around = basis_around(point.face);
    // Close to the surface as well: what juts out of an edge by a hair darkens all that lies right under it.
    for (const float height : {point.error, 0.05f * side}) {
        const vec3 above = point.position + point.face * (height + point.error);
        for (const int axis : {0, 1}) {
            const vec3 reach = around[axis] * (0.05f * side);
            if (scene.occluded({.origin = above - reach, .direction = 2.0f * reach, .farthest = 1.0f})) return false;
        }
    }
    return true;
}

}  // namespace

vec3 along_surface(const SurfacePoint& point, float level, vec2 step) {
    const std::uint32_t axis = facet_axis(point.normal());
    const vec3 face = facet_axes(point.face, axis);
    step *= std::exp2(level);
    const float off = std::abs(face.z) > 0.1f ? -glm::dot(vec2(face), step) / face.z : 0.0f;
    return point.position + from_axes(vec3(step, off), axis);
}

std::optional<SurfacePoint> surface_near(const TraceScene& scene, const SurfacePoint& from, vec3 target, float side) {
    for (const float height : {0.05f * side, 0.3f * side}) {
        const vec3 start = from.position + from.face * (height + from.error), above = target + from.face * (height + from.error);
        if (scene.occluded({.origin = start, .direction = above - start, .farthest = 1.0f})) continue;
        const auto hit = scene.intersect({.origin = above, .direction = -from.face, .farthest = 2.0f * height + 4.0f * from.error});
        if (!hit || !hit->front) continue;
        SurfacePoint point = scene.surface_at(*hit);
        // Not the next step down, and not the other side of a ridge.
        const bool level = std::abs(glm::dot(point.position - target, from.face)) <= most_slope * side;
        if (level && glm::dot(point.normal(), from.normal()) > 0.8f) return point;
    }
    return std::nullopt;
}

FacetCorner facet_corner(const TraceScene& scene, const SurfacePoint& point, float level, vec2 within, vec2 lattice) {
    const float side = std::exp2(level);
    const auto at = [&](float part) { return surface_near(scene, point, along_surface(point, level, part * (lattice - within)), side); };
    if (const auto corner = at(1.0f); corner && clear_around(scene, *corner, side)) return {.point = *corner, .shared = true};
    // Nearer to the middle, where the surface still is.
    for (const float part : {0.9f, 0.6f, 0.3f}) {
        if (const auto corner = at(part); corner && clear_around(scene, *corner, 0.5f * side * part)) return {.point = *corner, .cut = part < 0.9f};
    }
    return {.point = point, .cut = true};
}

}  // namespace sl
