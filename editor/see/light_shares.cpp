// SPDX-License-Identifier: MIT
#include "editor/see/light_shares.h"

#include <algorithm>

#include "engine/render/scene/light_map.h"
#include "engine/render/trace/direct_light.h"

namespace sl {

namespace {

/// How far off sunlight's lines begin, m.
constexpr float sun_distance = 30.0f;

bool is_blocked(const TransportWorld& world, std::size_t light, const ProbedPoint& point, vec3 position) {
    if (light >= world.lights.size() || world.casts[light] == 0) return false;
    SurfacePoint surface{};
    surface.position = position;
    surface.face = point.normal;
    surface.error = clearance(position);
    return world.scene.occluded(shadow_ray(world.lights[light], surface));
}

}  // namespace

std::vector<LightShare> light_shares(const RenderScene& scene, const ProbedPoint& point, const TransportWorld* world) {
    const std::vector<LightParams> lights = build_light_table(scene).params;
    const auto position = vec3(point.position - scene.origin);
    std::vector<LightShare> result;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const Incident incident = incident_light(lights[i], position);
        const vec3 to_light(incident.to_light);
        const vec3 irradiance = vec3(incident.irradiance) * std::max(glm::dot(point.normal, to_light), 0.0f);
        if (luminance(irradiance) <= 0.0f) continue;
        const float distance = lights[i].kind.x == light_directional ? sun_distance : incident.to_light.w;
        const dvec3 from = point.position + dvec3(to_light * distance);
        result.push_back({scene.lights[i].entity, irradiance, from, world != nullptr && is_blocked(*world, i, point, position)});
    }
    std::ranges::stable_sort(result, std::ranges::greater{}, [](const LightShare& share) { return luminance(share.irradiance); });
    return result;
}

vec3 arriving(const std::vector<LightShare>& shares) {
    vec3 sum(0.0f);
    for (const LightShare& share : shares) sum += share.blocked ? vec3(0.0f) : share.irradiance;
    return sum;
}

}  // namespace sl
