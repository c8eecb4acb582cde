// SPDX-License-Identifier: MIT
#include "engine/render/facets/patches.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "engine/render/facets/facet_corner.h"
#include "engine/render/trace/direct_light.h"
#include "engine/render/trace/directions.h"
#include "engine/render/trace/samples.h"
#include "shared/facets.h"

namespace sl {

namespace {

/// Side of a patch over its distance from the point that sees it.
constexpr float side_over_distance = 0.25f;
constexpr std::uint32_t links_of_a_patch = 32;
/// Strata, per side, in which a patch's direct light is sampled: of one that is lit evenly, and of one with a shadow's edge.
constexpr std::uint32_t few_strata = 4, many_strata = 8;
/// Of them, how many are lit for a first estimate of light that has changed.
constexpr std::size_t first_samples = 4;
/// Light that brings less than this share of what is there may change unnoticed.
constexpr float too_little = 0.005f;
/// Samples that differ by more than this share of their mean are uneven.
constexpr float even = 0.25f;
/// Farther apart in one cell, surfaces are other patches: normals, and heights over the side.
constexpr float least_cosine = 0.9f, most_height = 0.2f;
constexpr int most_in_a_cell = 4;
constexpr float halvings = 8.0f;
/// A patch is worth rays of its own where it is brighter than the mean of all that is seen by this factor.
constexpr float worth_a_ray = 2.0f;
/// What packing may turn a direction by, rad.
constexpr float packed_angle = 0.004f;
constexpr std::size_t most_targets = 24;
/// Radius of what sky is seen through, over its distance.
constexpr float size_of_an_opening = 0.12f;

float luminance(vec3 colour) { return glm::dot(colour, vec3(0.2126f, 0.7152f, 0.0722f)); }

/// What a surface gives back diffusely, its specular lobe spread over all directions.
vec3 albedo_of(const Surface& surface) {
    const float metallic = surface.normal.w;
    const vec3 base(surface.base_colour);
    const vec3 coat = base * metallic + vec3(0.04f * surface.specular.x) * (1.0f - metallic);
    return base * (1.0f - metallic) * (1.0f - 0.04f * surface.specular.x) + coat;
}

}  // namespace

void Patches::use(const TransportWorld& world) {
    world_ = &world;
    glowing_ = world.emitters.balls();
    const Bounds bounds = world.scene.bounds();
    coarsest_ = facet_level(glm::length(bounds.high - bounds.low), 1.0f / 16.0f);
}

Patches::Met Patches::by_chance(const Job& job, std::uint32_t number) const {
    SampleSequence samples(1, uvec2(job.seed, 0), number);
    GatherPoint& from = *job.point;
    const auto start = [&]() -> const SurfacePoint& {
        if (job.patch == nothing) return from.point;
        const std::vector<Sample>& starts = patches_[job.patch].samples;
        return starts.empty() ? from.point : starts[number * starts.size() / links_of_a_patch % starts.size()].point;
    };
    const SurfacePoint& point = start();
    const vec3 direction = basis_around(point.normal()) * cosine_direction(samples.pair());
    return follow(from, point, direction);
}

Patches::Met Patches::guided(const GatherPoint& from, std::uint32_t number) const {
    SampleSequence samples(3, uvec2(0), number);
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

bool Patches::belongs(const SurfacePoint& point, const Patch& patch) const {
    const SurfacePoint& middle = patch.middle.point;
    if (glm::dot(point.face, middle.face) < least_cosine) return false;
    const vec3 offset = middle.position - point.position;
    if (std::abs(glm::dot(offset, middle.face)) > most_height * patch.side) return false;
    // Close to the surface, so that low things part patches as well as walls do.
    const vec3 from = point.position + point.face * (0.02f * patch.side + point.error);
    const vec3 to = middle.position + middle.face * (0.02f * patch.side + middle.error);
    return !world_->scene.occluded({.origin = from, .direction = to - from, .farthest = 1.0f});
}

std::uint32_t Patches::find(const SurfacePoint& point, float level) const {
    for (float finer = 0.0f; finer <= halvings; ++finer) {
        const auto first = first_.find(facet_name(facet_cell(point.position, point.normal(), level - finer)));
        if (first == first_.end()) return nothing;
        int count = 0;
        for (std::uint32_t id = first->second; id != nothing; id = patches_[id].next, ++count) {
            if (belongs(point, patches_[id])) return id;
        }
        // Where a cell's surfaces do not see each other, smaller ones do.
        if (count < most_in_a_cell) return nothing;
    }
    return nothing;
}

std::uint32_t Patches::add(const SurfacePoint& point, float level, bool sharp) {
    const auto in_cell = [&](FacetName name) {
        const auto first = first_.find(name);
        int count = 0;
        if (first != first_.end()) for (std::uint32_t id = first->second; id != nothing; id = patches_[id].next) ++count;
        return count;
    };
    FacetName name = facet_name(facet_cell(point.position, point.normal(), level));
    for (float finer = 1.0f; finer <= halvings && in_cell(name) >= most_in_a_cell; ++finer) {
        --level;
        name = facet_name(facet_cell(point.position, point.normal(), level));
    }
    const auto id = static_cast<std::uint32_t>(patches_.size());
    Patch& patch = patches_.emplace_back();
    patch.middle.point = point;
    // What patches see is told apart less finely from one to the next; else one small patch would ask for such ones all over.
    patch.sharp = sharp;
    patch.middle.level = sharp ? level : std::min(level + 1.0f, std::max(level, coarsest_));
    patch.cell = name;
    patch.level = level;
    patch.side = std::exp2(level);
    const auto [first, fresh] = first_.try_emplace(name, id);
    if (!fresh) patch.next = std::exchange(first->second, id);
    wait(id);
    reflected_.push_back(vec3(0.0f));
    seen_.push_back(vec3(0.0f));
    return id;
}

void Patches::spread_samples(Patch& patch, std::uint32_t strata) const {
    const SurfacePoint& middle = patch.middle.point;
    const vec2 within(facet_cell(middle.position, middle.normal(), patch.level).within);
    patch.strata = strata;
    patch.samples.clear();
    for (std::uint32_t i = 0; i < strata * strata; ++i) {
        const vec2 xi = SampleSequence(2, uvec2(static_cast<std::uint32_t>(patch.cell), strata), i).pair();
        const vec3 place = along_surface(middle, patch.level, (vec2(i % strata, i / strata) + xi) / static_cast<float>(strata) - within);
        const float height = most_height * patch.side + middle.error;
        const auto hit = world_->scene.intersect({.origin = place + height * middle.face, .direction = -middle.face, .farthest = 2.0f * height});
        if (!hit || !hit->front) continue;
        const SurfacePoint point = world_->scene.surface_at(*hit);
        if (belongs(point, patch)) patch.samples.push_back({.point = point});
    }
    if (patch.samples.empty()) patch.samples.push_back({.point = middle});
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

bool Patches::passes(const GatherPoint& point, const Link& link, const Bounds& box) const {
    if (link.patch < nothing && patches_[link.patch].gone) return true;
    // A guided ray that went below the surface has met nothing anywhere.
    return link.direction != 0 && box.meets(point.point.position, unpack_normal(link.direction), link.distance);
}

void Patches::change(const TransportWorld& world, const Bounds& box, std::span<const Job> points) {
    use(world);
    forget(box);
    relink(points, box);
    // What patches see of each other can wait.
    changes_.push_back({.box = box});
}

bool Patches::mend(std::size_t most) {
    if (changes_.empty()) return false;
    PastChange& change = changes_.front();
    std::vector<Job> jobs;
    for (; change.mended < grown_ && jobs.size() < most; ++change.mended) {
        const auto id = static_cast<std::uint32_t>(change.mended);
        if (!patches_[id].gone) jobs.push_back({.point = &patches_[id].middle, .by_chance = links_of_a_patch, .seed = id + 1, .patch = id});
    }
    relink(jobs, change.box);
    if (change.mended >= grown_) changes_.erase(changes_.begin());
    return true;
}

void Patches::relink(std::span<const Job> jobs, const Bounds& box) {
    std::vector<std::vector<Probe>> passing(jobs.size());
    tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
        const Job& job = jobs[i];
        // Rays of a patch start all over it.
        const float start = job.patch == nothing ? 0.0f : patches_[job.patch].side;
        const Bounds wide = box.grown(start + packed_angle * glm::length(box.centre() - job.point->point.position));
        const auto look_at = [&](const std::vector<Link>& links, bool guided) {
            for (std::uint32_t k = 0; k < links.size(); ++k) {
                if (passes(*job.point, links[k], wide)) passing[i].push_back({&job, guided, k, {}});
            }
        };
        look_at(job.point->by_chance, false);
        look_at(job.point->guided, true);
    });
    std::vector<Probe> rays;
    for (auto& some : passing) rays.insert(rays.end(), some.begin(), some.end());
    trace(rays);
}

void Patches::forget(const Bounds& box) {
    tbb::parallel_for(std::size_t{0}, patches_.size(), [&](std::size_t id) {
        Patch& patch = patches_[id];
        const vec3 middle = patch.middle.point.position;
        if (box.contains(middle)) {
            patch.gone = true;
        } else if (box.grown(1.5f * patch.side).contains(middle)) {
            patch.samples.clear();
        } else {
            forget_shadows(patch, box);
        }
    });
    for (std::uint32_t id = 0; id < patches_.size(); ++id) {
        Patch& patch = patches_[id];
        const auto unlit = [](const Sample& sample) { return !sample.known; };
        if (patch.gone) {
            patch.albedo = patch.lit = patch.glow = patch.middle.irradiance = vec3(0.0f);
            set_radiosity(id);
            remove_from_cell(id);
        } else if (patch.samples.empty() || std::ranges::any_of(patch.samples, unlit)) {
            wait(id);
        }
    }
    const auto gone = [&](std::uint32_t id) { return patches_[id].gone; };
    std::erase_if(waiting_, gone);
    std::erase_if(rough_, gone);
}

void Patches::forget_shadows(Patch& patch, const Bounds& box) const {
    const SurfacePoint& middle = patch.middle.point;
    for (const LightParams& light : world_->lights) {
        const Ray to_light = shadow_ray(light, middle);
        const bool far = light.position.w > 0.0f && to_light.farthest <= 1.0f && glm::length(to_light.direction) > light.position.w + patch.side;
        if (far || !box.grown(1.5f * patch.side).meets(to_light.origin, to_light.direction, to_light.farthest)) continue;
        for (Sample& sample : patch.samples) {
            const Ray ray = shadow_ray(light, sample.point);
            sample.known = sample.known && !box.meets(ray.origin, ray.direction, ray.farthest);
        }
    }
    for (const Emitters::Ball& ball : glowing_) {
        if (!box.grown(ball.radius + 1.5f * patch.side).meets(middle.position, ball.place - middle.position, 1.0f)) continue;
        for (Sample& sample : patch.samples) sample.known = false;
    }
}

void Patches::remove_from_cell(std::uint32_t id) {
    const auto first = first_.find(patches_[id].cell);
    if (first == first_.end()) return;
    std::uint32_t* at = &first->second;
    while (*at != nothing && *at != id) at = &patches_[*at].next;
    if (*at == id) *at = patches_[id].next;
    if (first->second == nothing) first_.erase(first);
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

void Patches::wait(std::uint32_t id) {
    if (!std::exchange(patches_[id].waiting, true)) waiting_.push_back(id);
}

/// `irradiance`: of a patch, at most, by what has changed, lux.
template <class Irradiance>
void Patches::forget_where(Irradiance&& irradiance) {
    std::vector<char> matters(patches_.size());
    tbb::parallel_for(std::size_t{0}, patches_.size(), [&](std::size_t i) {
        const Patch& patch = patches_[i];
        const float known = patch.samples.empty() ? 0.0f : luminance(reflected_[i]) / std::max(luminance(patch.albedo), 1e-3f);
        matters[i] = !patch.gone && irradiance(patch) > too_little * known ? 1 : 0;
    });
    for (std::uint32_t id = 0; id < patches_.size(); ++id) {
        if (matters[id] == 0) continue;
        for (Sample& sample : patches_[id].samples) sample.known = false;
        wait(id);
    }
    // Those that are seen before those that light them.
    std::ranges::stable_partition(waiting_, [&](std::uint32_t id) { return patches_[id].sharp; });
}

void Patches::forget_light(std::span<const LightParams> lights) {
    forget_where([&](const Patch& patch) {
        float most = 0.0f;
        for (const LightParams& light : lights) {
            // Nearest to the light as far as the patch reaches.
            const SurfacePoint& point = patch.middle.point;
            vec3 place = point.position;
            if (light.kind.x != light_directional) {
                const vec3 offset = vec3(light.position) - place;
                const float distance = glm::length(offset);
                if (distance <= 1.5f * patch.side) return std::numeric_limits<float>::infinity();
                place += offset * (patch.side / distance);
            }
            const Incident incident = incident_light(light, place);
            if (glm::dot(point.normal(), vec3(incident.to_light)) > -0.2f) most = std::max(most, luminance(vec3(incident.irradiance)));
        }
        return most;
    });
}

void Patches::forget_light(std::span<const Emitters::Ball> glowing) {
    forget_where([&](const Patch& patch) {
        float sum = 0.0f;
        for (const Emitters::Ball& ball : glowing) {
            const vec3 offset = ball.place - patch.middle.point.position;
            const float distance = std::max(glm::length(offset) - patch.side, ball.radius);
            if (glm::dot(offset, patch.middle.point.face) > -patch.side - ball.radius) sum += ball.power / (3.0f * distance * distance);
        }
        return sum;
    });
}

bool Patches::renew(std::size_t most) {
    const bool rough = !waiting_.empty();
    std::vector<std::uint32_t>& list = rough ? waiting_ : rough_;
    const std::size_t count = std::min(most, list.size());
    const auto end = list.begin() + static_cast<std::ptrdiff_t>(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { light(list[i], !rough); });
    if (rough) {
        std::copy_if(list.begin(), end, std::back_inserter(rough_), [&](std::uint32_t id) { return patches_[id].waiting; });
        for (auto it = list.begin(); it != end; ++it) patches_[*it].waiting = false;
    }
    list.erase(list.begin(), end);
    return count > 0;
}

bool Patches::light_samples(Patch& patch, std::size_t every) const {
    // Of samples that are still in other light, the mean differs as much as of those that were asked.
    vec3 change(0.0f);
    float asked = 0.0f;
    for (std::size_t i = every / 2; i < patch.samples.size(); i += every) {
        Sample& sample = patch.samples[i];
        if (sample.known) continue;
        const vec3 lit = direct_irradiance(*world_, sample.point, SampleSequence(4, uvec2(static_cast<std::uint32_t>(patch.cell), 0), static_cast<std::uint32_t>(i)));
        change += albedo_of(sample.point.surface) * (lit - sample.lit);
        ++asked;
        sample.lit = lit;
        sample.known = true;
    }
    patch.albedo = patch.lit = patch.glow = vec3(0.0f);
    float low = std::numeric_limits<float>::infinity(), high = 0.0f, sum = 0.0f;
    vec3 bright(0.0f);
    std::array<float, many_strata * many_strata> brightness{};
    const auto count = static_cast<float>(patch.samples.size());
    for (std::size_t i = 0; i < patch.samples.size(); ++i) {
        const Sample& sample = patch.samples[i];
        const vec3 albedo = albedo_of(sample.point.surface);
        patch.albedo += albedo / count;
        patch.lit += (albedo * sample.lit + (sample.known ? vec3(0.0f) : change / std::max(asked, 1.0f))) / count;
        patch.glow += pi * sample.point.emission / count;
        const float size = luminance(albedo * sample.lit + pi * sample.point.emission);
        brightness[i] = size;
        bright += size * sample.point.position;
        low = std::min(low, size);
        high = std::max(high, size);
        sum += size;
    }
    patch.lit = glm::max(patch.lit, vec3(0.0f));
    // What of it is bright: the mean place, and twice the spread around it.
    patch.bright_place = sum > 0.0f ? bright / sum : patch.middle.point.position;
    float spread = 0.0f;
    for (std::size_t i = 0; i < patch.samples.size(); ++i) {
        const vec3 apart = patch.samples[i].point.position - patch.bright_place;
        spread += (sum > 0.0f ? brightness[i] / sum : 1.0f / count) * glm::dot(apart, apart);
    }
    patch.bright_radius = 2.0f * std::sqrt(spread) + patch.side / static_cast<float>(patch.strata);
    return high - low > even * sum / count;
}

void Patches::light(std::uint32_t id, bool all) {
    Patch& patch = patches_[id];
    if (patch.samples.empty()) {
        spread_samples(patch, few_strata);
        all = true;
    }
    const std::size_t every = all ? 1 : std::max<std::size_t>(patch.samples.size() / first_samples, 1);
    const bool uneven = light_samples(patch, every);
    // Stays on the list of those that want all their samples.
    patch.waiting = every > 1;
    if (every == 1 && uneven && patch.strata < many_strata) {
        spread_samples(patch, many_strata);
        light_samples(patch, 1);
    }
    set_radiosity(id);
}

void Patches::set_radiosity(std::uint32_t id) {
    const Patch& patch = patches_[id];
    reflected_[id] = black_ ? vec3(0.0f) : patch.lit + patch.albedo * patch.middle.irradiance;
    seen_[id] = reflected_[id] + patch.glow;
}

Patches::Gathered Patches::gather(const GatherPoint& point, const std::vector<vec3>& light) const {
    if (point.by_chance.empty()) return {};
    // One-sample balance heuristic of rays by chance and guided ones (Veach & Guibas 1995): each link's light over the
    // density with which all rays together take its direction.
    const auto by_chance = static_cast<float>(point.by_chance.size()), guided = static_cast<float>(point.guided.size());
    const vec3 sky_light = pi * world_->sky;
    vec3 sum(0.0f);
    float squares = 0.0f;
    for (const std::vector<Link>* links : {&point.by_chance, &point.guided}) {
        for (const Link& link : *links) {
            if (link.patch == nothing) continue;
            const vec3 arriving = (link.patch == sky ? sky_light : light[link.patch]) / (by_chance + guided * link.guided);
            sum += arriving;
            const float size = luminance(arriving);
            squares += size * size;
        }
    }
    const float mean = luminance(sum);
    return {.irradiance = sum, .error = std::sqrt(std::max(squares - mean * mean / (by_chance + guided), 0.0f))};
}

vec3 Patches::from_sky(const GatherPoint& point) const {
    if (point.by_chance.empty()) return vec3(0.0f);
    return static_cast<float>(std::ranges::count(point.by_chance, sky, &Link::patch)) / static_cast<float>(point.by_chance.size()) * pi * world_->sky;
}

float Patches::mean_light() const {
    double sum = 0.0;
    for (const vec3& light : reflected_) sum += luminance(light);
    return reflected_.empty() ? 0.0f : static_cast<float>(sum / static_cast<double>(reflected_.size()));
}

void Patches::forget_reflections(bool any) {
    black_ = !any;
    for (std::uint32_t id = 0; id < patches_.size(); ++id) {
        patches_[id].middle.irradiance = from_sky(patches_[id].middle);
        set_radiosity(id);
    }
}

float Patches::reflect(std::size_t first, std::size_t last) {
    std::vector<float> change(last - first);
    tbb::parallel_for(first, last, [&](std::size_t i) {
        GatherPoint& middle = patches_[i].middle;
        const vec3 before = middle.irradiance;
        middle.irradiance = gather(middle, reflected_).irradiance;
        change[i - first] = luminance(glm::abs(middle.irradiance - before) * patches_[i].albedo);
    });
    for (auto i = static_cast<std::uint32_t>(first); i < last; ++i) set_radiosity(i);
    return change.empty() ? 0.0f : *std::ranges::max_element(change);
}

}  // namespace sl
