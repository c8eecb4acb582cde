// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_cache.h"

#include <glm/gtc/packing.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

#include "engine/render/trace/directions.h"
#include "engine/render/trace/learn_light_paths.h"

namespace sl {

namespace {

/// The camera's rays go through other places of each square in as many frames; then everything that a still camera sees
/// has been met.
constexpr std::uint32_t most_looks = 16;
constexpr std::uint32_t most_depth = 3;
/// Corners that differ by this share of their mean get finer facets between them.
constexpr float smooth_contrast = 0.25f;
/// How far a surface may leave its facet's plane, over the facet's side.
constexpr float most_slope = 0.12f;
constexpr std::uint32_t first_samples = 16, least_samples = 64, most_samples = 2048;
constexpr std::uint32_t seed = 1;

float luminance(vec3 colour) { return glm::dot(colour, vec3(0.2126f, 0.7152f, 0.0722f)); }

/// What facets depend on besides the camera. The camera's own exposure and place are no part of it.
std::uint64_t content_of(const RenderScene& scene, const Facets& settings) {
    std::uint64_t hash = hash_mix(scene.geometry_hash(), scene.materials_hash);
    for (const RenderScene::Light& light : scene.lights) {
        const std::array<float, 14> values{light.position.x, light.position.y, light.position.z, light.direction.x, light.direction.y, light.direction.z,
                                           light.intensity.x, light.intensity.y, light.intensity.z, light.range, light.inner_cone, light.outer_cone,
                                           light.casts_shadow ? 1.0f : 0.0f, static_cast<float>(light.kind)};
        hash = hash_bytes(hash, values.data(), sizeof values);
    }
    hash = hash_bytes(hash, &scene.sky_radiance, sizeof(vec3));
    hash = hash_bytes(hash, &scene.origin, sizeof(dvec3));
    const std::array<float, 3> own{settings.spacing, settings.noise, static_cast<float>(settings.bounces)};
    return hash_bytes(hash, own.data(), sizeof own);
}

/// The vector whose lattice coordinates these are.
vec3 from_axes(vec3 v, std::uint32_t axis) {
    if (axis == 0) return vec3(v.z, v.x, v.y);
    if (axis == 1) return vec3(v.y, v.z, v.x);
    return v;
}

/// A pixel's side over its distance, times the pixels that a facet is wide.
float side_over_distance(const FrameParams& frame, const Facets& settings) {
    return settings.spacing * 2.0f * glm::length(vec3(frame.ray_up)) / frame.ray_up.w;
}

/// The middle of 16 strata, each met once in as many frames.
vec2 jitter(std::uint32_t look) {
    const std::uint32_t i = look % most_looks;
    return (vec2(i * 5 % 4 + (i / 4) % 4, i / 4) / 4.0f - glm::floor(vec2(i * 5 % 4 + (i / 4) % 4, i / 4) / 4.0f)) + 0.125f;
}

}  // namespace

float FacetCache::update(const RenderScene& scene, const FrameParams& frame, const Facets& settings, const Budget& budget) {
    const std::uint64_t content = content_of(scene, settings);
    const bool anew = !world_ || content != content_;
    if (anew) start_anew(scene, settings, content);
    const bool moved = std::memcmp(&seen_.clip_from_world, &frame.clip_from_world, sizeof(mat4)) != 0 || seen_.ray_up.w != frame.ray_up.w || seen_.ray_right.w != frame.ray_right.w;
    if (anew || moved) looks_ = 0;
    seen_ = frame;
    const bool at_once = budget.seconds <= 0.0;
    const std::size_t known = facets_.size();
    const std::uint64_t paths = paths_;
    do {
        if (looks_ < most_looks) look(frame, settings);
        if (anew && world_->light_paths.empty() && settings.bounces > 0 && !corners_.empty()) {
            learn_light_paths(*world_, corners_.size(), [&](std::size_t place, std::uint32_t number, std::vector<LitPoint>& lit) {
                PathSample out;
                gather_path(*world_, corners_[place].point, SampleSequence(seed + 1, uvec2(place, 0), number), out, {.lit = &lit});
            });
        }
        trace(settings, budget);
        split_where_needed(settings);
        // A camera that moves meets little that is new, and looks again in the next frame.
    } while (at_once && ((anew && looks_ < most_looks) || !unfinished_.empty()));
    // After a change the old light stays until each place has some of the new: a picture that is late by some frames, and
    // not one that falls dark. Those without samples come first.
    if (renewing_ && !unfinished_.empty() && corners_[unfinished_.front()].samples == 0) return share_known();
    renewing_ = false;
    if (facets_.size() != known || paths_ != paths || anew) {
        fill_table();
        ++version_;
    }
    return share_known();
}

float FacetCache::share_known() const {
    return corners_.empty() ? 1.0f : 1.0f - static_cast<float>(unfinished_.size()) / static_cast<float>(corners_.size());
}

void FacetCache::start_anew(const RenderScene& scene, const Facets& settings, std::uint64_t content) {
    content_ = content;
    renewing_ = table_.slots > 0;
    TransportSettings transport;
    transport.bounces = settings.bounces >= 64 ? TransportSettings::until_converged : static_cast<int>(settings.bounces);
    world_ = std::make_unique<TransportWorld>(scene, transport);
    facets_.clear();
    shared_corners_.clear();
    corners_.clear();
    unfinished_.clear();
    unsplit_.clear();
}

void FacetCache::look(const FrameParams& frame, const Facets& settings) {
    const vec2 size(frame.ray_right.w, frame.ray_up.w);
    const float spacing = std::max(settings.spacing, 1.0f);
    const uvec2 count(glm::ceil(size / spacing));
    const float side = side_over_distance(frame, settings);
    const vec2 within = jitter(looks_++);
    std::vector<std::optional<SurfacePoint>> hits(std::size_t{count.x} * count.y);
    tbb::parallel_for(std::size_t{0}, hits.size(), [&](std::size_t i) {
        const vec2 at = glm::min((vec2(i % count.x, i / count.x) + within) * spacing, size - 0.5f) / size;
        const Ray ray{.origin = vec3(frame.camera_position), .direction = view_ray(frame, vec2(2.0f * at.x - 1.0f, 1.0f - 2.0f * at.y)), .nearest = frame.camera_position.w};
        if (const auto hit = world_->scene.intersect_front(ray)) hits[i] = world_->scene.surface_at(*hit);
    });
    const auto known = static_cast<std::ptrdiff_t>(unfinished_.size());
    for (const auto& point : hits) {
        if (!point) continue;
        const float distance = glm::length(point->position - vec3(frame.camera_position));
        // Pixels beside this one are a little nearer or farther off: where the level changes they want the other one.
        const float near = facet_level(distance * 0.93f, side), far = facet_level(distance * 1.07f, side);
        add(*point, near, 0);
        if (far != near) add(*point, far, 0);
    }
    // All over the picture rather than from its top down: where the time of a frame ends, there is some light everywhere.
    std::sort(unfinished_.begin() + known, unfinished_.end(), [](std::uint32_t a, std::uint32_t b) { return a * 0x9e3779b1u < b * 0x9e3779b1u; });
}

void FacetCache::add(const SurfacePoint& point, float level, std::uint32_t depth) {
    const FacetCell cell = facet_cell(point.position, point.normal(), level);
    const Name name = name_of(cell);
    const auto [entry, fresh] = facets_.try_emplace(name);
    if (!fresh) return;
    Facet& facet = entry->second;
    facet.middle = point;
    facet.level = level;
    facet.depth = depth;
    for (std::uint32_t corner = 0; corner < 4; ++corner) facet.corners[corner] = corner_of(facet, vec2(corner & 1, corner >> 1), name, vec2(cell.within));
    unsplit_.push_back(name);
}

std::optional<SurfacePoint> FacetCache::surface_near(const SurfacePoint& from, vec3 target, float side) const {
    for (const float height : {0.05f * side, 0.3f * side}) {
        const vec3 start = from.position + from.face * (height + from.error), above = target + from.face * (height + from.error);
        if (world_->scene.occluded({.origin = start, .direction = above - start, .farthest = 1.0f})) continue;
        const auto hit = world_->scene.intersect({.origin = above, .direction = -from.face, .farthest = 2.0f * height + 4.0f * from.error});
        if (!hit || !hit->front) continue;
        SurfacePoint point = world_->scene.surface_at(*hit);
        // Not the next step down, and not the other side of a ridge.
        const bool level = std::abs(glm::dot(point.position - target, from.face)) <= most_slope * side;
        if (level && glm::dot(point.normal(), from.normal()) > 0.8f) return point;
    }
    return std::nullopt;
}

bool FacetCache::clear_around(const SurfacePoint& point, float side) const {
    const mat3 around = basis_around(point.face);
    // Close to the surface as well: what juts out of an edge by a hair darkens all that lies right under it.
    for (const float height : {point.error, 0.05f * side}) {
        const vec3 above = point.position + point.face * (height + point.error);
        for (const int axis : {0, 1}) {
            const vec3 reach = around[axis] * (0.05f * side);
            if (world_->scene.occluded({.origin = above - reach, .direction = 2.0f * reach, .farthest = 1.0f})) return false;
        }
    }
    return true;
}

std::uint32_t FacetCache::corner_of(const Facet& facet, vec2 lattice, Name name, vec2 within) {
    const float side = std::exp2(facet.level);
    const std::uint32_t axis = facet_axis(facet.middle.normal());
    const SurfacePoint& middle = facet.middle;
    // Along the surface to the corner, and off it by as much as its slope asks.
    const vec3 face = facet_axes(middle.face, axis);
    const auto along = [&](vec2 to) {
        const vec2 step = (to - within) * side;
        return middle.position + from_axes(vec3(step, std::abs(face.z) > 0.1f ? -glm::dot(vec2(face), step) / face.z : 0.0f), axis);
    };
    const auto keep = [&](const SurfacePoint& point) {
        corners_.push_back({.point = point});
        unfinished_.push_back(static_cast<std::uint32_t>(corners_.size()) - 1);
        return static_cast<std::uint32_t>(corners_.size()) - 1;
    };
    // Facets that meet at a corner share it, unless it lies in an edge or at the foot of something.
    const auto shared_name = [&] {
        const std::uint32_t u = (static_cast<std::uint32_t>(name) + static_cast<std::uint32_t>(lattice.x)) & 0xffffu;
        const std::uint32_t v = ((static_cast<std::uint32_t>(name) >> 16) + static_cast<std::uint32_t>(lattice.y)) & 0xffffu;
        return (name & ~Name{0xffffffffu}) | (v << 16) | u;
    }();
    if (const auto known = shared_corners_.find(shared_name); known != shared_corners_.end()) return known->second;
    auto point = surface_near(middle, along(lattice), side);
    if (point && clear_around(*point, side)) {
        const std::uint32_t corner = keep(*point);
        shared_corners_.emplace(shared_name, corner);
        return corner;
    }
    // Nearer to the middle, where the surface still is.
    for (const float part : {0.9f, 0.6f, 0.3f}) {
        point = surface_near(middle, along(glm::mix(within, lattice, part)), side);
        if (point && clear_around(*point, 0.5f * side * part)) {
            if (part < 0.9f) facets_[name].cut = true;
            return keep(*point);
        }
    }
    facets_[name].cut = true;
    return keep(middle);
}

void FacetCache::trace(const Facets& settings, const Budget& budget) {
    const auto start = std::chrono::steady_clock::now();
    const auto spent = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
    // First every place gets something.
    std::stable_partition(unfinished_.begin(), unfinished_.end(), [&](std::uint32_t corner) { return corners_[corner].samples == 0; });
    while (!unfinished_.empty()) {
        std::size_t batch = unfinished_.size();
        if (budget.seconds > 0.0) {
            const double left = budget.seconds - spent();
            if (left <= 0.0) break;
            batch = std::min(batch, static_cast<std::size_t>(left / (seconds_per_path_ * first_samples)) + 1);
        }
        std::atomic<std::uint64_t> traced = 0;
        const auto before = spent();
        tbb::parallel_for(std::size_t{0}, batch, [&](std::size_t i) {
            Corner& corner = corners_[unfinished_[i]];
            const std::uint32_t until = std::max(2 * corner.samples, first_samples);
            for (std::uint32_t number = corner.samples; number < until; ++number) {
                PathSample out;
                // The same directions at all corners: what they miss, neighbours miss alike, and no blotches arise.
                gather_path(*world_, corner.point, SampleSequence(seed, uvec2(0), number), out);
                const vec3 arriving = out.irradiance();
                corner.sum += glm::dvec3(arriving);
                corner.squares += double(luminance(arriving)) * luminance(arriving);
            }
            traced += until - corner.samples;
            corner.samples = until;
            const double mean = luminance(corner.irradiance());
            const double error = std::sqrt(std::max(corner.squares / until - mean * mean, 0.0) / until);
            // Where nothing arrived at all, its spread tells nothing either.
            const std::uint32_t least = mean > 0.0 ? least_samples : 4 * least_samples;
            corner.done = until >= least && (error <= settings.noise * mean || until >= most_samples);
        });
        paths_ += traced;
        if (traced > 0) seconds_per_path_ = (spent() - before) / static_cast<double>(traced.load());
        // Those that want more come last.
        std::vector<std::uint32_t> again;
        for (std::size_t i = 0; i < batch; ++i) {
            if (!corners_[unfinished_[i]].done) again.push_back(unfinished_[i]);
        }
        unfinished_.erase(unfinished_.begin(), unfinished_.begin() + static_cast<std::ptrdiff_t>(batch));
        unfinished_.insert(unfinished_.end(), again.begin(), again.end());
    }
}

void FacetCache::split_where_needed(const Facets&) {
    std::vector<Name> waiting;
    for (const Name name : std::exchange(unsplit_, {})) {
        Facet& facet = facets_.at(name);
        if (facet.depth >= most_depth) continue;
        float low = std::numeric_limits<float>::infinity(), high = 0.0f, sum = 0.0f;
        bool known = true;
        for (const std::uint32_t corner : facet.corners) {
            known &= corners_[corner].done;
            const float value = luminance(corners_[corner].irradiance());
            low = std::min(low, value);
            high = std::max(high, value);
            sum += 0.25f * value;
        }
        if (!known) {
            waiting.push_back(name);
            continue;
        }
        if (!facet.cut && high - low <= smooth_contrast * sum) continue;
        facet.split = true;
        const Facet parent = facet;
        const float side = std::exp2(parent.level);
        const std::uint32_t axis = facet_axis(parent.middle.normal());
        const FacetCell cell = facet_cell(parent.middle.position, parent.middle.normal(), parent.level);
        const vec3 face = facet_axes(parent.middle.face, axis);
        for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
            const vec2 step = (vec2(0.25f) + 0.5f * vec2(quarter & 1, quarter >> 1) - vec2(cell.within)) * side;
            const vec3 target = parent.middle.position + from_axes(vec3(step, std::abs(face.z) > 0.1f ? -glm::dot(vec2(face), step) / face.z : 0.0f), axis);
            if (const auto point = surface_near(parent.middle, target, side)) add(*point, parent.level - 1.0f, parent.depth + 1);
        }
        add(parent.middle, parent.level - 1.0f, parent.depth + 1);
    }
    unsplit_.insert(unsplit_.end(), waiting.begin(), waiting.end());
}

void FacetCache::fill_table() {
    float brightest = 0.0f;
    for (const Corner& corner : corners_) {
        const vec3 value = corner.irradiance();
        brightest = std::max({brightest, value.x, value.y, value.z});
    }
    table_.unit = brightest > 0.0f ? std::exp2(std::ceil(std::log2(brightest)) - 15.0f) : 1.0f;
    table_.slots = std::bit_ceil(static_cast<std::uint32_t>(std::max<std::size_t>(2 * facets_.size(), 16)));
    table_.words.assign(std::size_t{table_.slots} * 8, 0);
    table_.longest_search = 1;
    for (const auto& [name, facet] : facets_) {
        std::array<std::uint16_t, 12> halves{};
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const vec3 value = corners_[facet.corners[corner]].irradiance() / table_.unit;
            for (std::size_t c = 0; c < 3; ++c) halves[corner * 3 + c] = glm::packHalf1x16(value[static_cast<int>(c)]);
        }
        if (facet.split) halves[0] |= 0x8000u;
        const auto high = static_cast<std::uint32_t>(name >> 32), low = static_cast<std::uint32_t>(name);
        std::uint32_t at = facet_slot(high, low) & (table_.slots - 1), search = 1;
        while (table_.words[std::size_t{at} * 8] != 0) {
            at = (at + 1) & (table_.slots - 1);
            ++search;
        }
        table_.longest_search = std::max(table_.longest_search, search);
        std::uint32_t* slot = &table_.words[std::size_t{at} * 8];
        slot[0] = high;
        slot[1] = low;
        for (std::size_t i = 0; i < 6; ++i) slot[2 + i] = halves[2 * i] | (std::uint32_t{halves[2 * i + 1]} << 16);
    }
}

}  // namespace sl
