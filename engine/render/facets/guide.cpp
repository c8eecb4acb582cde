// SPDX-License-Identifier: MIT
#include "engine/render/facets/guide.h"

#include "engine/render/trace/directions.h"

namespace sl {

namespace {

/// Shares are changed where variance falls to this part of what it was; smaller shares than that are none.
constexpr float worth_learning = 0.7f, least_share = 0.002f;

}  // namespace

void Guide::add(vec3 place, float radius, float share, float widest) {
    for (Target& target : targets) {
        const float distance = glm::length(target.place - place);
        if (distance > 0.7f * (target.radius + radius)) continue;
        // The ball around both.
        if (distance + radius > target.radius) {
            const float grown = std::max(radius, 0.5f * (distance + radius + target.radius));
            if (grown > std::max(widest, target.radius)) continue;
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
    share_out();
}

void Guide::share_out() {
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

bool Guide::learn(const std::vector<Yield>& yields) {
    // Of one ray in a target, the squared light times the squared density; of as many as it has a share of, that over the share.
    std::vector<float> spread(targets.size());
    float sum = 0.0f, variance = 0.0f, rays = 0.0f;
    for (std::size_t i = 0; i < targets.size(); ++i) {
        spread[i] = std::sqrt(yields[i].rays * yields[i].squares);
        sum += spread[i];
        rays += yields[i].rays;
        variance += yields[i].squares;
    }
    if (!(rays > 0.0f) || !(sum * sum < worth_learning * variance * rays)) return false;
    for (std::size_t i = 0; i < targets.size(); ++i) targets[i].share = spread[i];
    std::erase_if(targets, [&](const Target& target) { return !(target.share > least_share * sum); });
    share_out();
    return true;
}

GuideCones::GuideCones(const Guide& guide, vec3 from) {
    cones_.reserve(guide.targets.size());
    for (const Guide::Target& target : guide.targets) {
        Cone& cone = cones_.emplace_back(Cone{.before = target.before});
        const vec3 offset = target.place - from;
        const float distance_squared = glm::dot(offset, offset), sine_squared = target.radius * target.radius / distance_squared;
        if (sine_squared < 1.0f) {
            cone.axis = offset / std::sqrt(distance_squared);
            // sin² / (1 + cos) keeps its digits for small cones.
            cone.versine = sine_squared / (1.0f + std::sqrt(1.0f - sine_squared));
        }
        cone.density = target.share / (2.0f * pi * cone.versine);
    }
}

vec3 GuideCones::sample(vec2 xi, float choice) const {
    const auto after = std::upper_bound(cones_.begin(), cones_.end(), choice, [](float value, const Cone& cone) { return value < cone.before; });
    const Cone& cone = *(after - 1);
    return basis_around(cone.axis) * cone_direction(cone.versine * xi.x, xi.y);
}

float GuideCones::density(vec3 direction) const {
    float result = 0.0f;
    for (const Cone& cone : cones_) result += cone.holds(direction) ? cone.density : 0.0f;
    return result;
}

void GuideCones::account(std::vector<Guide::Yield>& yields, vec3 direction, float light) const {
    yields.resize(cones_.size());
    const float all = density(direction);
    if (!(all > 0.0f)) return;
    for (std::size_t i = 0; i < cones_.size(); ++i) {
        if (!cones_[i].holds(direction)) continue;
        const float part = cones_[i].density / all;
        yields[i].rays += part;
        yields[i].squares += part * light * light;
    }
}

}  // namespace sl
