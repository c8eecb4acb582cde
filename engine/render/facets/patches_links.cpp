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
constexpr std::size_t most_targets = 48;
/// Radius, over its distance, up to which a ball of a guide may grow to hold several bright things.
constexpr float widest = 0.15f;
/// Radius of what sky is seen through, over its distance.
constexpr float size_of_an_opening = 0.12f;
/// Each use of random numbers has its own.
constexpr std::uint32_t chance_seed = 1, guide_seed = 3;

}  // namespace

Patches::Met Patches::by_chance(const Job& job, std::uint32_t number, const GuideCones& guide) const {
    SampleSequence samples(chance_seed, uvec2(job.seed, 0), number);
    GatherPoint& from = *job.point;
    const auto start = [&] {
        if (job.patch == nothing) return from.point;
        const std::vector<Sample>& starts = patches_[job.patch].samples;
        return starts.empty() ? from.point : starts[number * starts.size() / links_of_a_patch % starts.size()].place();
    };
    const SurfacePoint point = start();
    const vec3 direction = basis_around(point.normal()) * cosine_direction(samples.pair());
    return follow(from, point, direction, guide, job.patch == nothing);
}

Patches::Met Patches::guided(const GatherPoint& from, std::uint32_t number, const GuideCones& guide) const {
    SampleSequence samples(guide_seed, uvec2(0), number);
    const vec2 xi = samples.pair();
    const vec3 direction = guide.sample(xi, samples.pair().x);
    if (!(glm::dot(direction, from.point.normal()) > 0.0f)) return {};
    return follow(from, from.point, direction, guide, true);
}

Patches::Met Patches::follow(const GatherPoint& from, const SurfacePoint& start, vec3 direction, const GuideCones& guide, bool sharp) const {
    Met met;
    const float density = std::max(glm::dot(direction, start.normal()), 0.0f) / pi;
    met.direction = pack_normal(direction);
    if (density > 0.0f) met.guided = guide.density(direction) / density;
    const auto hit = world_.scene.intersect({.origin = start.origin_towards(direction), .direction = direction});
    if (!hit) {
        met.patch = sky;
        return met;
    }
    met.distance = hit->distance;
    if (!hit->front) return met;  // backs are black
    met.surface = true;
    met.point = world_.scene.surface_at(*hit);
    met.level = std::max(facet_level(hit->distance, side_over_distance), from.level);
    met.patch = find(met.point, met.level, sharp);
    return met;
}

void Patches::link(std::span<const Job> jobs) {
    std::vector<Probe> rays;
    for (const Job& job : jobs) {
        GatherPoint& point = *job.point;
        const auto by_chance = static_cast<std::uint32_t>(point.by_chance.size()), guided = static_cast<std::uint32_t>(point.guided.size());
        if (by_chance == 0) point.changes = all_changes_;
        for (std::uint32_t number = by_chance; number < job.by_chance; ++number) rays.push_back({&job, false, number, {}});
        const bool guide = point.guide != nullptr && !point.guide->empty();
        for (std::uint32_t number = guided; guide && number < job.by_chance / 2; ++number) rays.push_back({&job, true, number, {}});
    }
    trace(rays);
}

void Patches::trace(std::vector<Probe>& rays) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rays.size(), 32), [&](const auto& range) {
        const Job* job = nullptr;
        GuideCones guide;
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            Probe& ray = rays[i];
            if (std::exchange(job, ray.job) != ray.job) guide = job->point->guide != nullptr ? GuideCones(*job->point->guide, job->point->point.position) : GuideCones();
            ray.met = ray.guided ? guided(*job->point, ray.number, guide) : by_chance(*job, ray.number, guide);
        }
    });
    // One after the other, so that the same rays make the same patches on any number of threads.
    for (Probe& ray : rays) {
        Met& met = ray.met;
        if (met.surface) {
            if (met.patch == nothing) met.patch = find(met.point, met.level, ray.job->patch == nothing);
            if (met.patch == nothing) met.patch = add(met.point, met.level, ray.job->patch == nothing);
        }
        std::vector<Link>& links = ray.guided ? ray.job->point->guided : ray.job->point->by_chance;
        if (ray.number >= links.size()) links.resize(ray.number + 1);
        links[ray.number] = {met.patch, met.guided, met.distance, met.direction};
    }
}

bool Patches::grow(std::size_t most) {
    std::vector<Job> jobs;
    const std::size_t count = std::min(most, ungrown_.size());
    // Rays start all over a patch: its samples must be there.
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { (void)light(ungrown_[i], true); });
    for (const std::uint32_t id : std::span(ungrown_).first(count)) {
        // Each its own directions: their errors cancel in what others gather from them.
        jobs.push_back({.point = &patches_[id].middle, .by_chance = links_of_a_patch, .seed = id + 1, .patch = id});
    }
    ungrown_.erase(ungrown_.begin(), ungrown_.begin() + static_cast<std::ptrdiff_t>(count));
    link(jobs);
    return !jobs.empty();
}

Guide Patches::guide_for(std::span<const Job> points) const {
    if (points.empty()) return {};
    const vec3 middle = points[points.size() / 2].point->point.position;
    // What each thing brings is a share of what its point gets, so that the one point beside a lamp does not speak for all.
    std::vector<Bright> bright;
    std::unordered_map<std::uint32_t, std::size_t> of_patch;
    float irradiance = 0.0f;
    for (const Job& job : points) {
        const std::vector<Link>& links = job.point->by_chance;
        float total = 0.0f;
        for (const Link& link : links) total += brings(link);
        if (!(total > 0.0f)) continue;
        irradiance += total / static_cast<float>(links.size() * points.size());
        for (const Link& link : links) {
            const float share = brings(link) / total;
            if (!(share * static_cast<float>(links.size()) > worth_a_ray)) continue;
            if (link.patch == sky) {
                if (const auto opening = opening_beside(*job.point, link)) bright.push_back({.place = opening->place, .radius = opening->radius, .share = share});
            } else if (const auto [known, fresh] = of_patch.try_emplace(link.patch, bright.size()); fresh) {
                bright.push_back({.place = patches_[link.patch].bright_place, .radius = patches_[link.patch].bright_radius, .share = share});
            } else {
                bright[known->second].share += share;
            }
        }
    }
    // Lamps are known, and far too small to be found by chance. As bright as they are where nothing stands before them.
    for (const Emitters::Ball& ball : glowing_) {
        const vec3 offset = ball.place - middle;
        const float distance_squared = std::max(glm::dot(offset, offset), ball.radius * ball.radius);
        if (glm::dot(offset, points[points.size() / 2].point->point.face) < -ball.radius - 0.2f * std::sqrt(distance_squared)) continue;
        const float light = ball.power / (3.0f * distance_squared);
        if (light > 0.0f) bright.push_back({.place = ball.place, .radius = ball.radius, .share = static_cast<float>(points.size()) * light / (light + irradiance)});
    }
    std::ranges::stable_sort(bright, std::greater{}, &Bright::share);
    Guide guide;
    for (const Bright& it : bright) guide.add(it.place, it.radius, it.share, widest * glm::length(it.place - middle));
    guide.finish(most_targets);
    return guide;
}

bool Patches::improve(Guide& guide, std::span<const Job> points) const {
    std::vector<Guide::Yield> yields(guide.targets.size());
    for (const Job& job : points) {
        const GatherPoint& point = *job.point;
        const float all = luminance(point.irradiance);
        if (!(all > 0.0f)) continue;
        const auto by_chance = static_cast<float>(point.by_chance.size()), guided = static_cast<float>(point.guided.size());
        const GuideCones cones(guide, point.point.position);
        for (const Link& link : point.guided) {
            if (link.direction != 0) cones.account(yields, unpack_normal(link.direction), brings(link) / (by_chance + guided * link.guided) / all);
        }
    }
    return guide.learn(yields);
}

float Patches::brings(const Link& link) const {
    return link.patch == sky ? luminance(pi * world_.sky) : link.patch == nothing ? 0.0f : luminance(seen_[link.patch]);
}

std::optional<Patches::Opening> Patches::opening_beside(const GatherPoint& point, const Link& link) const {
    // Sky is seen past something, and taken to be an opening at the distance of what was met right beside it.
    const vec3 direction = unpack_normal(link.direction);
    float nearest = 4.0f, distance = 0.0f;
    for (const Link& beside : point.by_chance) {
        const vec3 apart = unpack_normal(beside.direction) - direction;
        if (beside.patch == sky || glm::dot(apart, apart) >= nearest) continue;
        nearest = glm::dot(apart, apart);
        distance = beside.distance;
    }
    if (!(distance > 0.0f)) return std::nullopt;
    return Opening{.place = point.point.position + distance * direction, .radius = size_of_an_opening * distance};
}

}  // namespace sl
