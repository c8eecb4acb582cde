// SPDX-License-Identifier: MIT
#include "engine/render/facets/patches.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "engine/render/trace/direct_light.h"

namespace sl {

namespace {

/// Of a patch's samples, how many are lit for a first estimate of light that has changed.
constexpr std::size_t first_samples = 4;
/// Samples whose standard deviation is over this share of their mean are uneven: a shadow's edge, and not a texture's grain.
constexpr float even = 0.3f;
constexpr std::uint32_t light_seed = 4;

/// What a light may bring within a distance of a place, lux.
float most_irradiance(const LightParams& light, vec3 place, float within) {
    if (light.kind.x == light_directional) return luminance(vec3(light.intensity));
    const float distance = glm::length(place - vec3(light.position)) - 1.5f * within;
    if (distance <= 0.0f) return std::numeric_limits<float>::infinity();
    return luminance(vec3(light.intensity)) * range_window(distance * distance, light.position.w) / (distance * distance);
}

}  // namespace

void Patches::Patch::forget_light() {
    if (++light != 0) return;
    for (Sample& sample : samples) sample.lit_in = 0;
    light = 1;
}

void Patches::wait(std::uint32_t id) {
    if (!std::exchange(patches_[id].waiting, true)) waiting_.push_back(id);
}

float Patches::brings(const Emitters::Ball& ball, vec3 place, float within) {
    const float distance = std::max(glm::length(ball.place - place) - within, ball.radius);
    return ball.power / (3.0f * distance * distance);
}

/// `most` of a place and a side, `irradiance` of a patch: what has changed brings there at most, lux; the first may be more.
template <class Most, class Irradiance>
void Patches::forget_where(Most&& most, Irradiance&& irradiance) {
    std::vector<char> matters(patches_.size());
    tbb::parallel_for(std::size_t{0}, patches_.size(), [&](std::size_t i) {
        // Most are too far off, which their place alone tells: they have more light than it could bring.
        if (places_[i].w < 0.0f || !(most(vec3(places_[i]), places_[i].w) > too_little * luminance(reflected_[i]))) return;
        const Patch& patch = patches_[i];
        const float known = patch.samples.empty() ? 0.0f : luminance(reflected_[i]) / std::max(luminance(patch.albedo), 1e-3f);
        matters[i] = !patch.gone && irradiance(patch) > too_little * known ? 1 : 0;
    });
    for (std::uint32_t id = 0; id < patches_.size(); ++id) {
        if (matters[id] == 0) continue;
        patches_[id].forget_light();
        wait(id);
    }
    // Those that are seen before those that light them.
    std::ranges::stable_partition(waiting_, [&](std::uint32_t id) { return patches_[id].sharp; });
}

void Patches::forget_light(std::span<const LightParams> lights) {
    const auto most_at = [&](vec3 place, float side) {
        float most = 0.0f;
        for (const LightParams& light : lights) most = std::max(most, most_irradiance(light, place, side));
        return most;
    };
    forget_where(most_at, [&](const Patch& patch) {
        float most = 0.0f;
        for (const LightParams& light : lights) {
            // Nearest to the light and to its axis as far as the patch reaches.
            const SurfacePoint& point = patch.middle.point;
            vec3 place = point.position;
            if (light.kind.x != light_directional) {
                const vec3 offset = place - vec3(light.position), axis(light.direction);
                const float distance = glm::length(offset);
                if (distance <= 1.5f * patch.side) return std::numeric_limits<float>::infinity();
                const vec3 to_axis = axis * glm::dot(offset, axis) - offset;
                const float apart = light.kind.x == light_spot ? glm::length(to_axis) : 0.0f;
                if (apart > 0.0f) place += to_axis * std::min(patch.side / apart, 1.0f);
                place -= offset * (patch.side / distance);
            }
            const Incident incident = incident_light(light, place);
            if (glm::dot(point.normal(), vec3(incident.to_light)) > -0.2f) most = std::max(most, luminance(vec3(incident.irradiance)));
        }
        return most;
    });
}

void Patches::forget_light(std::span<const Emitters::Ball> glowing) {
    const auto most_at = [&](vec3 place, float side) {
        float sum = 0.0f;
        for (const Emitters::Ball& ball : glowing) sum += brings(ball, place, side);
        return sum;
    };
    forget_where(most_at, [&](const Patch& patch) {
        float sum = 0.0f;
        for (const Emitters::Ball& ball : glowing) {
            const vec3 offset = ball.place - patch.middle.point.position;
            if (glm::dot(offset, patch.middle.point.face) > -patch.side - ball.radius) sum += brings(ball, patch.middle.point.position, patch.side);
        }
        return sum;
    });
}

bool Patches::renew(std::size_t most) {
    std::vector<std::uint32_t>& list = !dark_.empty() ? dark_ : !waiting_.empty() ? waiting_ : rough_;
    const bool rough = &list == &rough_;
    const std::vector<std::uint32_t> batch(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(std::min(most, list.size())));
    list.erase(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(batch.size()));
    std::vector<char> enough(batch.size());
    tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t i) { enough[i] = light(batch[i], rough) ? 1 : 0; });
    for (std::size_t i = 0; i < batch.size(); ++i) {
        Patch& patch = patches_[batch[i]];
        (rough ? patch.rough : patch.waiting) = false;
        if (enough[i] == 0 && !std::exchange(patch.rough, true)) rough_.push_back(batch[i]);
    }
    return !batch.empty();
}

bool Patches::light_samples(Patch& patch, std::size_t every) const {
    static thread_local std::vector<char> narrowly;
    narrowly.assign(world_.lights.size(), 0);
    for (std::uint32_t i = 0; i < narrowly.size(); ++i) narrowly[i] = narrow(i, patch) ? 1 : 0;
    // Of samples that are still in other light, the mean differs as much as of those that were asked.
    vec3 change(0.0f);
    float asked = 0.0f;
    for (std::size_t i = every / 2; i < patch.samples.size(); i += every) {
        Sample& sample = patch.samples[i];
        if (patch.knows(sample)) continue;
        const vec3 lit = direct_irradiance(world_, sample.place(), SampleSequence(light_seed, uvec2(static_cast<std::uint32_t>(patch.cell), 0), static_cast<std::uint32_t>(i)), narrowly);
        change += sample.albedo() * (lit - sample.lit);
        ++asked;
        sample.lit = lit;
        sample.lit_in = patch.light;
    }
    patch.albedo = patch.lit = vec3(0.0f);
    float sum = 0.0f, squares = 0.0f;
    vec3 bright(0.0f);
    std::array<float, many_strata * many_strata> brightness{};
    const auto count = static_cast<float>(patch.samples.size());
    for (std::size_t i = 0; i < patch.samples.size(); ++i) {
        const Sample& sample = patch.samples[i];
        const vec3 albedo = sample.albedo();
        patch.albedo += albedo / count;
        patch.lit += (albedo * sample.lit + (patch.knows(sample) ? vec3(0.0f) : change / std::max(asked, 1.0f))) / count;
        const float size = luminance(albedo * sample.lit) + sample.glow;
        brightness[i] = size;
        bright += size * sample.position;
        sum += size;
        squares += size * size;
    }
    patch.lit = glm::max(patch.lit, vec3(0.0f));
    const bool disagree = squares * count > (1.0f + even * even) * sum * sum;
    const SurfacePoint& middle = patch.middle.point;
    const float part = count / static_cast<float>(patch.strata * patch.strata), cosine = std::abs(facet_axes(middle.face, facet_axis(middle.normal())).z);
    for (std::uint32_t i = 0; i < narrowly.size(); ++i) {
        if (narrowly[i] == 0) continue;
        const Narrow found = light_narrowly(i, patch);
        const vec3 lit = found.flux * cosine / (part * patch.side * patch.side);
        patch.lit += lit;
        sum += count * luminance(lit);
        bright += count * luminance(lit) * found.place;
    }
    // What of it is bright: the mean place, and twice the spread around it.
    patch.bright_place = sum > 0.0f ? bright / sum : patch.middle.point.position;
    float spread = 0.0f;
    for (std::size_t i = 0; i < patch.samples.size(); ++i) {
        const vec3 apart = patch.samples[i].position - patch.bright_place;
        spread += (sum > 0.0f ? brightness[i] / sum : 1.0f / count) * glm::dot(apart, apart);
    }
    patch.bright_radius = 2.0f * std::sqrt(spread) + patch.side / static_cast<float>(patch.strata);
    return disagree;
}

bool Patches::light(std::uint32_t id, bool all) {
    Patch& patch = patches_[id];
    // Its middle alone, for a patch that is still dark: half the truth at once is better than all of it too late.
    const bool dark = patch.strata == 0, unsampled = patch.samples.empty();
    if (dark && !all) {
        spread_samples(patch, 1);
    } else if (unsampled || patch.strata < few_strata) {
        spread_samples(patch, std::max(patch.strata, few_strata));
    }
    const std::size_t every = all || unsampled ? 1 : std::max<std::size_t>(patch.samples.size() / first_samples, 1);
    const bool uneven = light_samples(patch, every);
    if (!dark && every == 1 && uneven && patch.strata < many_strata) {
        spread_samples(patch, many_strata);
        light_samples(patch, 1);
    }
    set_radiosity(id);
    return patch.strata > 1 && every == 1;
}

void Patches::set_radiosity(std::uint32_t id) {
    const Patch& patch = patches_[id];
    reflected_[id] = black_ ? vec3(0.0f) : patch.lit + patch.albedo * patch.middle.irradiance;
    seen_[id] = reflected_[id] + patch.glow;
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

void Patches::forget_reflections(bool any) {
    black_ = !any;
    for (std::uint32_t id = 0; id < patches_.size(); ++id) {
        patches_[id].middle.irradiance = from_sky(patches_[id].middle);
        set_radiosity(id);
    }
}

Patches::Gathered Patches::gather(const GatherPoint& point, const std::vector<vec3>& light) const {
    if (point.by_chance.empty()) return {};
    // Balance heuristic of rays by chance and guided ones (Veach & Guibas 1995): each link's light over the
    // density with which all rays together take its direction.
    const auto by_chance = static_cast<float>(point.by_chance.size()), guided = static_cast<float>(point.guided.size());
    const vec3 sky_light = pi * world_.sky;
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
    return static_cast<float>(std::ranges::count(point.by_chance, sky, &Link::patch)) / static_cast<float>(point.by_chance.size()) * pi * world_.sky;
}

float Patches::mean_light() const {
    double sum = 0.0;
    for (const vec3& light : reflected_) sum += luminance(light);
    const std::size_t patches = patches_.size() - gone_.size() - free_.size();
    return patches == 0 ? 0.0f : static_cast<float>(sum / static_cast<double>(patches));
}

}  // namespace sl
