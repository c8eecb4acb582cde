// SPDX-License-Identifier: MIT
#include "engine/render/trace/direct_light.h"

#include <algorithm>

namespace sl {

namespace {

constexpr std::size_t most_rays = 4;

struct Candidate {
    vec3 irradiance;
    std::uint32_t light;
};

float sum(vec3 v) { return v.x + v.y + v.z; }

bool arrives(const TransportWorld& world, const SurfacePoint& point, std::uint32_t light) {
    return world.casts[light] == 0 || !world.scene.occluded(shadow_ray(world.lights[light], point));
}

}  // namespace

Ray shadow_ray(const LightParams& light, const SurfacePoint& point) {
    if (light.kind.x == light_directional) {
        const vec3 to_light = -vec3(light.direction);
        return {.origin = point.origin_towards(to_light), .direction = to_light};
    }
    // To the light itself, not along the direction that the surface had: in a corner the two differ.
    const vec3 origin = point.origin_towards(vec3(light.position) - point.position);
    return {.origin = origin, .direction = vec3(light.position) - origin, .farthest = 1.0f};
}

namespace {

vec3 from_lights(const TransportWorld& world, const SurfacePoint& point, float xi, std::span<const char> without) {
    static thread_local std::vector<Candidate> candidates;
    candidates.clear();
    for (std::uint32_t i = 0; i < world.lights.size(); ++i) {
        if (!without.empty() && without[i] != 0) continue;
        const Incident incident = incident_light(world.lights[i], point.position);
        const vec3 irradiance = vec3(incident.irradiance) * std::max(glm::dot(point.normal(), vec3(incident.to_light)), 0.0f);
        if (sum(irradiance) > 0.0f) candidates.push_back({irradiance, i});
    }
    vec3 result(0.0f);
    if (candidates.size() <= most_rays) {
        for (const Candidate& candidate : candidates) {
            if (arrives(world, point, candidate.light)) result += candidate.irradiance;
        }
        return result;
    }
    // Systematic resampling: evenly spaced marks on the candidates laid end to end.
    float total = 0.0f;
    for (const Candidate& candidate : candidates) total += sum(candidate.irradiance);
    const float step = total / most_rays;
    float mark = xi * step, before = 0.0f;
    for (const Candidate& candidate : candidates) {
        const float end = before + sum(candidate.irradiance);
        float marks = 0.0f;
        for (; mark < end; mark += step) ++marks;
        if (marks > 0.0f && arrives(world, point, candidate.light)) result += candidate.irradiance * (marks * step / sum(candidate.irradiance));
        before = end;
    }
    return result;
}

vec3 from_emitters(const TransportWorld& world, const SurfacePoint& point, vec2 xi) {
    if (world.emitters.empty()) return vec3(0.0f);
    const auto path = world.emitters.path_from(world.scene, point, xi);
    if (!path || world.scene.occluded(path->ray)) return vec3(0.0f);
    return path->radiance * (glm::dot(path->direction, point.normal()) / path->density);
}

}  // namespace

vec3 direct_irradiance(const TransportWorld& world, const SurfacePoint& point, SampleSequence samples, std::span<const char> without) {
    const vec3 lights = from_lights(world, point, samples.pair().x, without);
    return lights + from_emitters(world, point, samples.pair());
}

}  // namespace sl
