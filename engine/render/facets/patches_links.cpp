// SPDX-License-Identifier: MIT
#include "engine/render/facets/patches.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "engine/render/trace/directions.h"
#include "engine/render/trace/samples.h"

namespace sl {

namespace {

/// Side of a patch over its distance from the point that sees it.
constexpr float side_over_distance = 0.25f;
/// A patch is worth rays of its own where it is brighter than the mean of all that is seen by this factor.
constexpr float worth_a_ray = 2.0f;
constexpr std::size_t most_targets = 24;
/// Radius of what sky is seen through, over its distance.
constexpr float size_of_an_opening = 0.12f;
/// Each use of random numbers has its own.
constexpr std::uint32_t chance_seed = 1, guide_seed = 3;

}  // namespace

Patches::Met Patches::by_chance(const Job& job, std::uint32_t number) const {
    SampleSequence samples(chance_seed, uvec2(job.seed, 0), number);
    GatherPoint& from = *job.point;
    const auto start = [&] {
        if (job.patch == nothing) return from.point;
        const std::vector<Sample>& starts = patches_[job.patch].samples;
        return starts.empty() ? from.point : starts[number * starts.size() / links_of_a_patch % starts.size()].place();
    };
    const SurfacePoint point = start();
    const vec3 direction = basis_around(point.normal()) * cosine_direction(samples.pair());
    return follow(from, point, direction);
}

Patches::Met Patches::guided(const GatherPoint& from, std::uint32_t number) const {
    SampleSequence samples(guide_seed, uvec2(0), number);
    const vec2 xi = samples.pair();
    const vec3 direction = from.guide->sample(from.point.position, xi, samples.pair().x);
    if (!(glm::dot(direction, from.point.normal()) > 0.0f)) return {};
    return follow(from, from.point, direction);
}

Patches::Met Patches::follow(const GatherPoint& from, const SurfacePoint& start, vec3 direction) const {
    Met met;
    const float density = std::max(glm::dot(direction, start.normal()), 0.0f) / pi;
    met.direction = pack_normal(direction);
    if (from.guide != nullptr && density > 0.0f) met.guided = from.guide->density(start.position, direction) / density;
    const auto hit = world_->scene.intersect({.origin = start.origin_towards(direction), .direction = direction});
    if (!hit) {
        met.patch = sky;
        return met;
    }
    met.distance = hit->distance;
    if (!hit->front) return met;  // backs are black
    met.surface = true;
    met.point = world_->scene.surface_at(*hit);
    met.level = std::max(facet_level(hit->distance, side_over_distance), from.level);
    met.patch = find(met.point, met.level);
    return met;
}

void Patches::link(std::span<const Job> jobs) {
    std::vector<Probe> rays;
    for (const Job& job : jobs) {
        const GatherPoint& point = *job.point;
        const auto by_chance = static_cast<std::uint32_t>(point.by_chance.size()), guided = static_cast<std::uint32_t>(point.guided.size());
        for (std::uint32_t number = by_chance; number < job.by_chance; ++number) rays.push_back({&job, false, number, {}});
        const bool guide = point.guide != nullptr && !point.guide->empty();
        for (std::uint32_t number = guided; guide && number < job.by_chance / 2; ++number) rays.push_back({&job, true, number, {}});
    }
    trace(rays);
}

void Patches::trace(std::vector<Probe>& rays) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rays.size(), 32), [&](const auto& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) rays[i].met = rays[i].guided ? guided(*rays[i].job->point, rays[i].number) : by_chance(*rays[i].job, rays[i].number);
    });
    // One after the other, so that the same rays make the same patches on any number of threads.
    for (Probe& ray : rays) {
        Met& met = ray.met;
        if (met.surface) {
            if (met.patch == nothing) met.patch = find(met.point, met.level);
            if (met.patch == nothing) met.patch = add(met.point, met.level, ray.job->patch == nothing);
        }
        std::vector<Link>& links = ray.guided ? ray.job->point->guided : ray.job->point->by_chance;
        if (ray.number >= links.size()) links.resize(ray.number + 1);
        links[ray.number] = {met.patch, met.guided, met.distance, met.direction};
    }
}

bool Patches::grow(std::size_t most) {
    std::vector<Job> jobs;
    for (; grown_ < patches_.size() && jobs.size() < most; ++grown_) {
        if (patches_[grown_].gone) continue;
        // Each its own directions: their errors cancel in what others gather from them.
        const auto id = static_cast<std::uint32_t>(grown_);
        jobs.push_back({.point = &patches_[id].middle, .by_chance = links_of_a_patch, .seed = id + 1, .patch = id});
    }
    link(jobs);
    return !jobs.empty();
}

Guide Patches::guide_for(std::span<const Job> points) const {
    if (points.empty()) return {};
    const float sky_light = luminance(pi * world_->sky);
    float total = 0.0f, rays = 0.0f;
    const auto brings = [&](const Link& link) { return link.patch == sky ? sky_light : link.patch == nothing ? 0.0f : luminance(seen_[link.patch]); };
    for (const Job& job : points) {
        for (const Link& link : job.point->by_chance) total += brings(link);
        rays += static_cast<float>(job.point->by_chance.size());
    }
    Guide guide;
    for (const Job& job : points) {
        const std::vector<Link>& links = job.point->by_chance;
        for (const Link& link : links) {
            const float light = brings(link);
            if (!(light > worth_a_ray * total / rays)) continue;
            if (link.patch != sky) {
                const Patch& patch = patches_[link.patch];
                guide.add(patch.bright_place, patch.bright_radius, light);
                continue;
            }
            // Sky is seen past something, and taken to be an opening at the distance of what was met right beside it.
            const vec3 direction = unpack_normal(link.direction);
            float nearest = 4.0f, distance = 0.0f;
            for (const Link& beside : links) {
                const vec3 apart = unpack_normal(beside.direction) - direction;
                if (beside.patch == sky || glm::dot(apart, apart) >= nearest) continue;
                nearest = glm::dot(apart, apart);
                distance = beside.distance;
            }
            if (distance > 0.0f) guide.add(job.point->point.position + distance * direction, size_of_an_opening * distance, light);
        }
    }
    guide_to_glow(points, rays, guide);
    guide.finish(most_targets);
    return guide;
}

void Patches::guide_to_glow(std::span<const Job> points, float rays, Guide& guide) const {
    // Lamps are known, and far too small to be found by chance. As bright as they are where nothing stands before them.
    const SurfacePoint& middle = points[points.size() / 2].point->point;
    std::vector<std::pair<float, const Emitters::Ball*>> bright;
    for (const Emitters::Ball& ball : glowing_) {
        const vec3 offset = ball.place - middle.position;
        const float distance_squared = std::max(glm::dot(offset, offset), ball.radius * ball.radius);
        if (glm::dot(offset, middle.face) < -ball.radius - 0.2f * std::sqrt(distance_squared)) continue;
        bright.emplace_back(ball.power / (3.0f * distance_squared), &ball);
    }
    const std::size_t kept = std::min(bright.size(), most_targets);
    std::ranges::partial_sort(bright, bright.begin() + static_cast<std::ptrdiff_t>(kept), std::greater{}, &std::pair<float, const Emitters::Ball*>::first);
    for (std::size_t i = 0; i < kept; ++i) guide.add(bright[i].second->place, bright[i].second->radius, rays * bright[i].first);
}

}  // namespace sl
