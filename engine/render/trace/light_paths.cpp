// SPDX-License-Identifier: MIT
#include "engine/render/trace/light_paths.h"

#include <algorithm>
#include <cmath>

#include "engine/render/trace/directions.h"

namespace sl {

vec2 LightPaths::Source::coordinates(vec3 point) const {
    if (parallel) return vec2(glm::dot(point, basis[0]), glm::dot(point, basis[1]));
    const vec3 direction = glm::normalize(point - position);
    const vec3 off_axis = direction - basis[2];
    const float round = std::atan2(glm::dot(direction, basis[1]), glm::dot(direction, basis[0])) / (2.0f * pi);
    return vec2(0.5f * glm::dot(off_axis, off_axis), round < 0.0f ? round + 1.0f : round);
}

Ray LightPaths::Source::ray(vec2 at) const {
    if (parallel) return {.origin = position + basis[0] * at.x + basis[1] * at.y, .direction = basis[2]};
    return {.origin = position, .direction = glm::normalize(basis * cone_direction(at.x, at.y))};
}

LightPaths::Source LightPaths::source_of(std::uint32_t light, const LightParams& params, const Bounds& bounds) {
    Source source{.light = light, .parallel = params.kind.x == light_directional, .position = vec3(params.position), .basis = mat3(1.0f)};
    if (params.kind.x != light_point) source.basis = basis_around(vec3(params.direction));
    if (source.parallel) {
        const vec3 axis = source.basis[2];
        const vec3 first(axis.x > 0.0f ? bounds.low.x : bounds.high.x, axis.y > 0.0f ? bounds.low.y : bounds.high.y, axis.z > 0.0f ? bounds.low.z : bounds.high.z);
        source.position = axis * (glm::dot(first, axis) - 0.01f * glm::length(bounds.high - bounds.low));
    }
    return source;
}

LightPaths::LightPaths(std::span<const LightParams> lights, const Bounds& bounds, std::span<const LitPoint> found) {
    std::vector<std::vector<WeightedPoint>> points(lights.size());
    float total = 0.0f;
    std::vector<Source> sources;
    for (std::uint32_t i = 0; i < lights.size(); ++i) sources.push_back(source_of(i, lights[i], bounds));
    for (const LitPoint& point : found) {
        points[point.light].push_back({sources[point.light].coordinates(point.position), point.weight});
        total += point.weight;
    }
    if (!(total > 0.0f)) return;
    float before = 0.0f;
    for (Source& source : sources) {
        std::vector<WeightedPoint>& own = points[source.light];
        if (own.empty()) continue;
        vec2 high = own.front().at;
        source.low = high;
        float weight = 0.0f;
        for (const WeightedPoint& point : own) {
            source.low = glm::min(source.low, point.at);
            high = glm::max(high, point.at);
            weight += point.weight;
        }
        // A little more than the points cover, so that their last ones lie inside, and one point alone has a cell.
        const vec2 margin = 1e-3f * (high - source.low) + 1e-6f * glm::max(glm::abs(high), glm::abs(source.low)) + 1e-30f;
        source.low -= margin;
        high += margin;
        if (!source.parallel) {
            // Beyond these coordinates lie directions that have others already.
            source.low = glm::max(source.low, vec2(0.0f));
            high = glm::min(high, vec2(2.0f, 1.0f));
        }
        source.size = high - source.low;
        for (WeightedPoint& point : own) point.at = glm::clamp((point.at - source.low) / source.size, 0.0f, 0.99999994f);
        source.rays = SquareDensity(own);
        source.before = before;
        source.share = weight / total;
        before += source.share;
        sources_.push_back(std::move(source));
    }
}

LightPaths LightPaths::everywhere(std::span<const LightParams> lights, const Bounds& bounds, const std::vector<char>& which) {
    LightPaths paths;
    if (bounds.empty()) return paths;
    const auto count = static_cast<float>(std::ranges::count_if(which, [](char one) { return one != 0; }));
    for (std::uint32_t i = 0; i < lights.size(); ++i) {
        if (which[i] == 0) continue;
        Source source = source_of(i, lights[i], bounds);
        if (source.parallel) {
            source.low = vec2(std::numeric_limits<float>::max());
            vec2 high(std::numeric_limits<float>::lowest());
            for (int corner = 0; corner < 8; ++corner) {
                const vec2 at = source.coordinates(vec3(corner & 1 ? bounds.high.x : bounds.low.x, corner & 2 ? bounds.high.y : bounds.low.y, corner & 4 ? bounds.high.z : bounds.low.z));
                source.low = glm::min(source.low, at);
                high = glm::max(high, at);
            }
            source.size = glm::max(high - source.low, 1e-30f);
        } else {
            // The ramp at a spot's edge ends where cone.y = cone.x · (1 - cos).
            source.size = vec2(cone_versine(lights[i]), 1.0f);
        }
        source.share = 1.0f / count;
        source.before = static_cast<float>(paths.sources_.size()) / count;
        paths.sources_.push_back(std::move(source));
    }
    return paths;
}

LightPaths::Drawn LightPaths::sample(vec2 xi) const {
    const auto after = std::upper_bound(sources_.begin(), sources_.end(), xi.x, [](float x, const Source& source) { return x < source.before; });
    const Source& source = *(after - 1);
    xi.x = std::clamp((xi.x - source.before) / source.share, 0.0f, 0.99999994f);
    return {source.light, source.ray(source.low + source.size * source.rays.sample(xi))};
}

float LightPaths::density(std::uint32_t light, const SurfacePoint& point) const {
    const auto found = std::ranges::find(sources_, light, &Source::light);
    if (found == sources_.end()) return 0.0f;
    const Source& source = *found;
    const vec3 offset = point.position - source.position;
    const float distance_squared = glm::dot(offset, offset);
    const vec3 travel = source.parallel ? source.basis[2] : offset / std::sqrt(distance_squared);
    const float across = source.share * source.rays.density((source.coordinates(point.position) - source.low) / source.size) / (source.size.x * source.size.y);
    const float on_surface = across * std::max(-glm::dot(travel, point.face), 0.0f);
    return source.parallel ? on_surface : on_surface / (2.0f * pi * distance_squared);
}

}  // namespace sl
