// SPDX-License-Identifier: MIT
#include "engine/render/facets/patches.h"

#include <glm/gtc/packing.hpp>

#include "engine/render/facets/facet_corner.h"
#include "engine/render/trace/mean_albedo.h"
#include "engine/render/trace/samples.h"

namespace sl {

namespace {

/// Farther apart in one cell, surfaces are other patches: normals, and heights over the side.
constexpr float least_cosine = 0.9f, most_height = 0.2f;
constexpr int most_in_a_cell = 4;
constexpr std::uint32_t place_seed = 2;
/// How much finer cells may be where more patches than that would lie in one, in halvings: of those that shown points see, and
/// of others. In the finest, which hold what is smaller than can matter by itself, the most alike of its patches stands for it.
constexpr float most_halvings = 3.0f, most_halvings_of_others = 1.0f;
constexpr float alike = 0.5f;  ///< cosine of what is
/// What glows differs by at most this factor within a patch.
constexpr float most_contrast = 4.0f;

/// A lamp and the ceiling that it hangs below are two things: the mean of both is a lamp as large as the patch, whose
/// shadows have no edges.
bool glow_alike(float one, float other) { return std::max(one, other) <= most_contrast * std::min(one, other); }

}  // namespace

Patches::Sample::Sample(const SurfacePoint& point)
    : position(point.position),
      glow(luminance(pi * point.emission)),
      error_(point.error),
      face_(pack_normal(point.face)),
      normal_(pack_normal(point.normal())),
      albedo_(glm::packF3x9_E1x5(mean_albedo(point.surface))) {}

SurfacePoint Patches::Sample::place() const {
    return {.position = position, .face = unpack_normal(face_), .surface = {.normal = vec4(unpack_normal(normal_), 0.0f)}, .emission = vec3(0.0f), .error = error_};
}

vec3 Patches::Sample::albedo() const { return glm::unpackF3x9_E1x5(albedo_); }

void Patches::measure_world() {
    glowing_ = world_.emitters.balls();
    const Bounds bounds = world_.scene.bounds();
    coarsest_ = facet_level(glm::length(bounds.high - bounds.low), 1.0f / 16.0f);
}

Patches::Mark::Mark(const Patch& patch)
    : position(patch.middle.point.position), side(patch.side), face(patch.middle.point.face), error(patch.middle.point.error), glow(luminance(patch.middle.point.emission)) {}

bool Patches::belongs(const SurfacePoint& point, const Mark& mark) const {
    if (glm::dot(point.face, mark.face) < least_cosine || !glow_alike(luminance(point.emission), mark.glow)) return false;
    const vec3 offset = mark.position - point.position;
    if (std::abs(glm::dot(offset, mark.face)) > most_height * mark.side) return false;
    // Close to the surface, so that low things part patches as well as walls do.
    const vec3 from = point.position + point.face * (0.02f * mark.side + point.error);
    const vec3 to = mark.position + mark.face * (0.02f * mark.side + mark.error);
    return !world_.scene.occluded({.origin = from, .direction = to - from, .farthest = 1.0f});
}

std::uint32_t Patches::find(const SurfacePoint& point, float level, bool sharp) const {
    const float most = sharp ? most_halvings : most_halvings_of_others;
    for (float finer = 0.0f; finer <= most; ++finer) {
        const auto first = first_.find(facet_name(facet_cell(point.position, point.normal(), level - finer)));
        if (first == first_.end()) return nothing;
        int count = 0;
        for (std::uint32_t id = first->second; id != nothing; id = marks_[id].next, ++count) {
            if (belongs(point, marks_[id])) return id;
        }
        // Where a cell's surfaces do not see each other, smaller ones do.
        if (count < most_in_a_cell) return nothing;
        if (finer == most) return most_alike(point, first->second);
    }
    return nothing;
}

std::uint32_t Patches::most_alike(const SurfacePoint& point, std::uint32_t first) const {
    std::uint32_t best = nothing;
    float closest = alike;
    for (std::uint32_t id = first; id != nothing; id = marks_[id].next) {
        const Mark& mark = marks_[id];
        // A side apart counts as much as a right angle.
        const float likeness = glm::dot(point.face, mark.face) - glm::length(point.position - mark.position) / mark.side;
        if (glm::dot(point.face, mark.face) < alike || (best != nothing && likeness <= closest)) continue;
        closest = likeness;
        best = id;
    }
    return best;
}

std::uint32_t Patches::add(const SurfacePoint& point, float level, bool sharp) {
    const auto in_cell = [&](FacetName name) {
        const auto first = first_.find(name);
        int count = 0;
        if (first != first_.end()) for (std::uint32_t id = first->second; id != nothing; id = marks_[id].next) ++count;
        return count;
    };
    FacetName name = facet_name(facet_cell(point.position, point.normal(), level));
    const float asked = level, most = sharp ? most_halvings : most_halvings_of_others;
    for (float finer = 1.0f; finer <= most && in_cell(name) >= most_in_a_cell; ++finer) {
        --level;
        name = facet_name(facet_cell(point.position, point.normal(), level));
    }
    const std::uint32_t id = place_for_one_more();
    Patch& patch = patches_[id];
    patch.middle.point = point;
    // What patches see is told apart less finely from one to the next; else one small patch would ask for such ones all over.
    patch.sharp = sharp;
    patch.middle.level = sharp ? asked : std::min(asked + 1.0f, std::max(asked, coarsest_));
    patch.cell = name;
    patch.level = level;
    patch.side = std::exp2(level);
    const vec2 within(facet_cell(point.position, point.normal(), level).within);
    places_[id] = vec4(along_surface(point, level, 0.5f - within), patch.side);
    marks_[id] = Mark(patch);
    const auto [first, fresh] = first_.try_emplace(name, id);
    if (!fresh) marks_[id].next = std::exchange(first->second, id);
    patch.waiting = true;
    dark_.push_back(id);
    ungrown_.push_back(id);
    return id;
}

std::uint32_t Patches::place_for_one_more() {
    if (!free_.empty()) {
        const std::uint32_t id = free_.back();
        free_.pop_back();
        patches_[id] = Patch{};
        return id;
    }
    patches_.emplace_back();
    marks_.emplace_back();
    reflected_.push_back(vec3(0.0f));
    seen_.push_back(vec3(0.0f));
    places_.emplace_back();
    return static_cast<std::uint32_t>(patches_.size() - 1);
}

void Patches::remove_from_cell(std::uint32_t id) {
    const auto first = first_.find(patches_[id].cell);
    if (first == first_.end()) return;
    std::uint32_t* at = &first->second;
    while (*at != nothing && *at != id) at = &marks_[*at].next;
    if (*at == id) *at = marks_[id].next;
    if (first->second == nothing) first_.erase(first);
}

std::size_t Patches::memory() const {
    // Those of one kind differ little in what they hold.
    return (patches_.size() - gone_.size() - free_.size()) * (sizeof(Patch) + sizeof(Mark) + links_of_a_patch * sizeof(Link) + few_strata * few_strata * sizeof(Sample));
}

void Patches::spread_samples(Patch& patch, std::uint32_t strata) const {
    const SurfacePoint& middle = patch.middle.point;
    const Mark mark(patch);
    const vec2 within(facet_cell(middle.position, middle.normal(), patch.level).within);
    patch.strata = strata;
    patch.samples.clear();
    vec3 emission(0.0f);
    // One alone is the middle.
    for (std::uint32_t i = 0; strata > 1 && i < strata * strata; ++i) {
        const vec2 xi = SampleSequence(place_seed, uvec2(static_cast<std::uint32_t>(patch.cell), strata), i).pair();
        const vec3 place = along_surface(middle, patch.level, (vec2(i % strata, i / strata) + xi) / static_cast<float>(strata) - within);
        const float height = most_height * patch.side + middle.error;
        const auto hit = world_.scene.intersect({.origin = place + height * middle.face, .direction = -middle.face, .farthest = 2.0f * height});
        if (!hit || !hit->front) continue;
        const SurfacePoint point = world_.scene.surface_at(*hit);
        if (!belongs(point, mark)) continue;
        patch.samples.emplace_back(point);
        emission += point.emission;
    }
    if (patch.samples.empty()) {
        patch.samples.emplace_back(middle);
        emission = middle.emission;
    }
    patch.samples.shrink_to_fit();
    patch.glow = pi / static_cast<float>(patch.samples.size()) * emission;
}

}  // namespace sl
