// SPDX-License-Identifier: MIT
// Light that falls on so little of a patch that places spread over it would miss it: it is asked for from the light's side.
#include <algorithm>

#include "engine/render/facets/patches.h"
#include "engine/render/trace/directions.h"
#include "engine/render/trace/mean_albedo.h"
#include "engine/render/trace/samples.h"

namespace sl {

namespace {

/// Rays from one light.
constexpr std::uint32_t rays_of_a_light = 16;
/// Radius of a lit circle, and distance of a lamp from the surface, over the patch's side, below which its samples may miss it.
constexpr float narrow_radius = 0.5f, close_by = 0.2f;
/// From its first point, over its side, how far a patch may reach.
constexpr float from_first_point = 1.6f;
constexpr std::uint32_t narrow_seed = 5;

}  // namespace

bool Patches::narrow(std::uint32_t number, const Patch& patch) const {
    const LightParams& light = world_.lights[number];
    // One that shines through everything reaches more than what its rays meet first.
    if (light.kind.x == light_directional || world_.casts[number] == 0) return false;
    const vec3 offset = patch.middle.point.position - vec3(light.position);
    const float distance = glm::length(offset), radius = from_first_point * patch.side;
    if (distance <= radius && std::abs(glm::dot(offset, patch.middle.point.face)) < close_by * patch.side) return true;
    const float cosine = 1.0f - cone_versine(light);
    // tan² of the cone against the circle's radius over the distance.
    const float sine_squared = 1.0f - cosine * cosine;
    if (!(cosine > 0.0f) || sine_squared * distance * distance > narrow_radius * narrow_radius * patch.side * patch.side * cosine * cosine) return false;
    // The cone's edge, as far as the patch reaches: angle to the axis below the sum of both half angles.
    const float to_axis = std::atan2(glm::length(glm::cross(offset, vec3(light.direction))), glm::dot(offset, vec3(light.direction)));
    return distance <= radius || to_axis < std::acos(cosine) + std::asin(radius / distance);
}

Patches::Narrow Patches::light_narrowly(std::uint32_t number, const Patch& patch) const {
    const LightParams& light = world_.lights[number];
    const float versine = cone_versine(light);
    const mat3 around = basis_around(light.kind.x == light_spot ? vec3(light.direction) : patch.middle.point.face);
    // Lumen that a ray carries at the full intensity.
    const vec3 flux = vec3(light.intensity) * (2.0f * pi * versine / static_cast<float>(rays_of_a_light));
    const Mark mark(patch);
    Narrow result;
    for (std::uint32_t i = 0; i < rays_of_a_light; ++i) {
        const vec2 xi = SampleSequence(narrow_seed, uvec2(static_cast<std::uint32_t>(patch.cell), number), i).pair();
        const vec3 direction = around * cone_direction(versine * xi.x, xi.y);
        const auto hit = world_.scene.intersect({.origin = vec3(light.position), .direction = direction});
        if (!hit || !hit->front) continue;
        const SurfacePoint point = world_.scene.surface_at(*hit);
        if (facet_name(facet_cell(point.position, point.normal(), patch.level)) != patch.cell || !belongs(point, mark)) continue;
        const float falloff = light.kind.x == light_spot ? cone_falloff(light.cone, vec3(light.direction), direction) : 1.0f;
        const vec3 reflected = mean_albedo(point.surface) * flux * (falloff * range_window(hit->distance * hit->distance, light.position.w));
        result.flux += reflected;
        result.place += luminance(reflected) * point.position;
    }
    if (const float size = luminance(result.flux); size > 0.0f) result.place /= size;
    return result;
}

}  // namespace sl
