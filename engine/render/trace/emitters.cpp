// SPDX-License-Identifier: MIT
#include "engine/render/trace/emitters.h"

#include <algorithm>
#include <cmath>

namespace sl {

Emitters::Emitters(const TraceScene& scene) {
    double total = 0.0;
    std::vector<double> power, area;
    for (std::uint32_t draw = 0; draw < scene.draw_count(); ++draw) {
        if (!scene.glows(draw)) continue;
        for (std::uint32_t triangle = 0; triangle < scene.triangle_count(draw); ++triangle) {
            const vec3 radiance = scene.plain_emission(draw, triangle);
            if (radiance.x + radiance.y + radiance.z <= 0.0f) continue;
            const auto corners = scene.corners(draw, triangle);
            const double size = 0.5 * glm::length(glm::cross(dvec3(corners[1] - corners[0]), dvec3(corners[2] - corners[0])));
            if (!(size > 0.0)) continue;
            triangles_.push_back({.corners = corners, .draw = draw, .triangle = triangle, .density = 0.0f, .power = 0.0f, .share_before = 0.0f});
            area.push_back(size);
            power.push_back(size * (radiance.x + radiance.y + radiance.z));
            total += power.back();
        }
    }
    double before = 0.0;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        Glowing& glowing = triangles_[i];
        glowing.share_before = static_cast<float>(before / total);
        glowing.power = static_cast<float>(power[i]);
        glowing.density = static_cast<float>(power[i] / (total * area[i]));
        densities_[key(glowing.draw, glowing.triangle)] = glowing.density;
        before += power[i];
    }
}

std::vector<Emitters::Ball> Emitters::balls() const {
    std::vector<Ball> result;
    for (const Glowing& glowing : triangles_) {
        const auto& [a, b, c] = glowing.corners;
        const vec3 middle = (a + b + c) / 3.0f;
        const float radius = std::max({glm::length(a - middle), glm::length(b - middle), glm::length(c - middle)});
        result.push_back({.place = middle, .radius = radius, .normal = glm::normalize(glm::cross(b - a, c - a)), .power = glowing.power});
    }
    return result;
}

EmitterSample Emitters::sample(vec2 xi) const {
    const auto after = std::upper_bound(triangles_.begin(), triangles_.end(), xi.x, [](float value, const Glowing& g) { return value < g.share_before; });
    const Glowing& glowing = *(after - 1);
    const float next = after == triangles_.end() ? 1.0f : after->share_before;
    // What chose the triangle, stretched back to the whole interval, is as good as a number of its own.
    const float x = std::clamp((xi.x - glowing.share_before) / std::max(next - glowing.share_before, 1e-20f), 0.0f, 0.99999994f);
    const float root = std::sqrt(x);
    const float u = root * (1.0f - xi.y), v = root * xi.y;
    EmitterSample result;
    result.position = (1.0f - u - v) * glowing.corners[0] + u * glowing.corners[1] + v * glowing.corners[2];
    result.hit = {.draw = glowing.draw, .triangle = glowing.triangle, .u = u, .v = v};
    result.density = glowing.density;
    return result;
}

float Emitters::density(const TriangleHit& hit) const {
    if (densities_.empty()) return 0.0f;
    const auto found = densities_.find(key(hit.draw, hit.triangle));
    return found != densities_.end() ? found->second : 0.0f;
}

std::optional<EmitterPath> Emitters::path_from(const TraceScene& scene, const SurfacePoint& point, vec2 xi) const {
    const EmitterSample drawn = sample(xi);
    const SurfacePoint emitter = scene.surface_at(drawn.hit);
    const vec3 origin = point.origin_towards(drawn.position - point.position);
    const vec3 offset = emitter.position - origin;
    const float distance_squared = glm::dot(offset, offset);
    if (distance_squared <= 0.0f) return std::nullopt;
    const vec3 direction = offset / std::sqrt(distance_squared);
    const float cos_emitter = -glm::dot(direction, emitter.face);
    if (cos_emitter <= 0.0f || !point.faces(direction)) return std::nullopt;
    return EmitterPath{.direction = direction, .radiance = emitter.emission, .density = drawn.density * distance_squared / cos_emitter,
                       .ray = {.origin = origin, .direction = emitter.origin_towards(-direction) - origin, .farthest = 1.0f}};
}

float Emitters::path_density(const TriangleHit& hit, const SurfacePoint& point, vec3 direction) const {
    const float cos_emitter = -glm::dot(direction, point.face);
    return cos_emitter > 0.0f ? density(hit) * hit.distance * hit.distance / cos_emitter : 0.0f;
}

}  // namespace sl
