// SPDX-License-Identifier: MIT
#include "engine/render/facets/guide.h"

#include "engine/render/trace/directions.h"

namespace sl {

namespace {

/// The cone in which a ball is seen: 1 - cos of its half angle. From inside it is everything around.
struct Cone {
    vec3 axis{0, 0, 1};
    float versine = 2.0f;
};
Cone cone_of(const Guide::Target& target, vec3 from) {
    const vec3 offset = target.place - from;
    const float distance_squared = glm::dot(offset, offset), sine_squared = target.radius * target.radius / distance_squared;
    if (!(sine_squared < 1.0f)) return {};
    // sin² / (1 + cos) keeps its digits for small cones.
    return {.axis = offset / std::sqrt(distance_squared), .versine = sine_squared / (1.0f + std::sqrt(1.0f - sine_squared))};
}

}  // namespace

void Guide::add(vec3 place, float radius, float share) {
    for (Target& target : targets) {
        const float distance = glm::length(target.place - place);
        if (distance > 0.7f * (target.radius + radius)) continue;
        // The ball around both.
        if (distance + radius > target.radius) {
            const float grown = std::max(radius, 0.5f * (distance + radius + target.radius));
            if (distance > 0.0f) target.place = grown > target.radius ? target.place + (place - target.place) * ((grown - target.radius) / distance) : target.place;
            target.radius = grown;
        }
        target.share += share;
        return;
    }
    targets.push_back({.place = place, .radius = radius, .share = share});
}

void Guide::finish(std::size_t most) {
    std::ranges::stable_sort(targets, std::greater{}, &Target::share);
    if (targets.size() > most) targets.resize(most);
    float sum = 0.0f, before = 0.0f;
    for (const Target& target : targets) sum += target.share;
    // Light too faint or too strong for float: by chance alone, then.
    if (!(sum > 0.0f) || !std::isfinite(sum)) targets.clear();
    for (Target& target : targets) {
        target.share /= sum;
        target.before = before;
        before += target.share;
    }
}

vec3 Guide::sample(vec3 from, vec2 xi, float choice) const {
    const auto after = std::upper_bound(targets.begin(), targets.end(), choice, [](float value, const Target& target) { return value < target.before; });
    const Cone cone = cone_of(*(after - 1), from);
    const float below = cone.versine * xi.x, angle = 2.0f * pi * xi.y;  // 1 - cos, evenly spread over the solid angle
    const float sine = std::sqrt(std::max(below * (2.0f - below), 0.0f));
    return basis_around(cone.axis) * vec3(sine * std::cos(angle), sine * std::sin(angle), 1.0f - below);
}

float Guide::density(vec3 from, vec3 direction) const {
    float result = 0.0f;
    for (const Target& target : targets) {
        const Cone cone = cone_of(target, from);
        const vec3 difference = direction - cone.axis;  // 1 - cos = |difference|² / 2
        if (0.5f * glm::dot(difference, difference) <= cone.versine) result += target.share / (2.0f * pi * cone.versine);
    }
    return result;
}

}  // namespace sl
