// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_cache.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sl {

namespace {

/// Corners that differ by this share of their mean get finer facets between them.
constexpr float smooth_contrast = 0.25f;
constexpr std::uint32_t smooth_splits = 3;
/// Of the lattice off a surface.
constexpr float slabs_of_a_side = 8.0f;
constexpr float glaring = 3.0f;
/// In a facet that is being made.
constexpr std::uint32_t no_corner = ~0u;
/// A group of corners lies in a square of 8 by 8 facets.
constexpr float group_level = 3.0f;

/// Steps, in sides, across a quarter of a facet up its slope: one for each slab of the finer lattice that it passes through.
std::vector<vec2> steps_across_a_quarter(const SurfacePoint& point) {
    const vec3 face = facet_axes(point.face, facet_axis(point.normal()));
    const vec2 slope = std::abs(face.z) > 0.1f ? vec2(face) / face.z : vec2(0.0f);
    const float rise = std::abs(slope.x) + std::abs(slope.y);
    const auto slabs = static_cast<std::uint32_t>(std::ceil(slabs_of_a_side * rise - 1e-3f));
    std::vector<vec2> steps{vec2(0.0f)};
    for (std::uint32_t i = 0; i <= slabs && slabs > 0; ++i) {
        // Between the corners that are lowest and highest.
        const float part = static_cast<float>(i) / static_cast<float>(slabs) - 0.5f;
        steps.push_back(0.49f * part * vec2(std::copysign(1.0f, slope.x), std::copysign(1.0f, slope.y)));
    }
    return steps;
}

/// The name under which facets that meet at a corner share it.
FacetName corner_name(FacetName facet, uvec2 lattice) {
    const std::uint32_t u = (static_cast<std::uint32_t>(facet) + lattice.x) & 0xffffu, v = ((static_cast<std::uint32_t>(facet) >> 16) + lattice.y) & 0xffffu;
    return (facet & ~FacetName{0xffffffffu}) | (v << 16) | u;
}

}  // namespace

std::optional<FacetCache::Wanted> FacetCache::finer_at(const SurfacePoint& point, float level) const {
    for (std::uint32_t depth = 0;; ++depth) {
        const FacetName name = facet_name(facet_cell(point.position, point.normal(), level - static_cast<float>(depth)));
        const auto known = facets_.find(name);
        if (known == facets_.end()) {
            if (depth == 0) return std::nullopt;
            return Wanted{.point = point, .level = level - static_cast<float>(depth), .root = facet_name(facet_cell(point.position, point.normal(), level)), .depth = depth};
        }
        const Facet& facet = known->second;
        if (facet.stand_in || !facet.split) return std::nullopt;
    }
}

void FacetCache::add(std::span<const Wanted> wanted) {
    struct Fresh {
        FacetName name;
        Facet* facet;
        std::array<std::optional<FacetCorner>, 4> corners;
    };
    std::vector<Fresh> fresh;
    for (const Wanted& it : wanted) {
        const FacetName name = facet_name(facet_cell(it.point.position, it.point.normal(), it.level));
        const auto [entry, is_fresh] = facets_.try_emplace(name);
        Facet& facet = entry->second;
        if (is_fresh) {
            facet = {.middle = it.point, .level = it.level, .depth = it.depth, .corners = {no_corner}, .stand_in = it.stand_in, .root = it.root != 0 ? it.root : name, .seen = all_looks_};
            fresh.push_back({name, &facet, {}});
        } else if (!it.stand_in && std::exchange(facet.stand_in, false) && facet.corners[0] != no_corner) {
            ask_for_finer(name, facet);
        }
    }
    if (fresh.empty()) return;
    tbb::parallel_for(std::size_t{0}, fresh.size(), [&](std::size_t i) {
        const auto& [name, facet, corners] = fresh[i];
        const vec2 within(facet_cell(facet->middle.position, facet->middle.normal(), facet->level).within);
        for (std::uint32_t corner = 0; corner < 4; ++corner) {
            const uvec2 lattice(corner & 1, corner >> 1);
            if (shared_corners_.contains(corner_name(name, lattice))) continue;
            fresh[i].corners[corner] = facet_corner(world_->scene, facet->middle, facet->level, within, vec2(lattice));
        }
    });
    for (const auto& [name, facet, corners] : fresh) {
        const float depth = static_cast<float>(facet->depth), group = facet->level + group_level + (facet->stand_in ? -stand_in_coarser : depth);
        // Corners of fine facets are so many that patches as fine as they are would take most of the time.
        const float finest_patch = facet->level - (facet->depth > 0 ? 0.0f : 1.0f);
        for (std::uint32_t corner = 0; corner < 4; ++corner) facet->cut |= !shared_corners_.contains(corner_name(name, uvec2(corner & 1, corner >> 1))) && corners[corner]->cut;
        if (facet->cut && facet->depth > 0) {
            // A good square is no more to be had, and one place must do.
            facet->corners.fill(add_corner({.point = facet->middle}, finest_patch, group));
            corners_[facet->corners[0]].fine = true;
        } else {
            for (std::uint32_t corner = 0; corner < 4; ++corner) {
                const FacetName shared_name = corner_name(name, uvec2(corner & 1, corner >> 1));
                const auto known = shared_corners_.find(shared_name);
                if (known != shared_corners_.end()) {
                    facet->corners[corner] = known->second;
                    continue;
                }
                const std::uint32_t id = facet->corners[corner] = add_corner(*corners[corner], finest_patch, group);
                corners_[id].stands_in = facet->stand_in;
                corners_[id].fine = facet->depth > 0;
                if (!corners[corner]->shared) continue;
                shared_corners_.emplace(shared_name, id);
                corners_[id].shared_as = shared_name;
            }
        }
        for (const std::uint32_t corner : facet->corners) ++corners_[corner].users;
        if (!facet->stand_in) ask_for_finer(name, *facet);
    }
    table_is_old_ = shown_are_old_ = true;
}

void FacetCache::ask_for_finer(FacetName name, Facet& facet) {
    if (facet.cut && facet.depth < smooth_splits) {
        facet.split = true;
    } else {
        unsplit_.push_back(name);
        for (const std::uint32_t number : facet.corners) {
            Corner& corner = corners_[number];
            if (!std::exchange(corner.to_stay, true) && std::exchange(corner.done, false)) unfinished_.push_back(number);
        }
    }
    table_is_old_ = shown_are_old_ = true;
}

std::uint32_t FacetCache::add_corner(const FacetCorner& corner, float level, float level_of_group) {
    auto id = static_cast<std::uint32_t>(corners_.size());
    if (free_corners_.empty()) {
        corners_.emplace_back();
    } else {
        id = free_corners_.back();
        free_corners_.pop_back();
    }
    const FacetName cell = facet_name(facet_cell(corner.point.position, corner.point.normal(), level_of_group));
    const std::uint32_t group = group_at(cell);
    groups_[group].seen = all_looks_;
    corners_[id] = {.at = {.point = corner.point, .level = level, .guide = groups_[group].guide.get()}, .group = group};
    groups_[group].corners.push_back(id);
    unfinished_.push_back(id);
    return id;
}

std::uint32_t FacetCache::group_at(FacetName cell) {
    const auto [known, fresh] = group_of_cell_.try_emplace(cell, static_cast<std::uint32_t>(groups_.size()));
    if (!fresh) return known->second;
    if (free_groups_.empty()) {
        groups_.emplace_back();
    } else {
        known->second = free_groups_.back();
        free_groups_.pop_back();
    }
    groups_[known->second].cell = cell;
    unguided_.push_back(known->second);
    return known->second;
}

void FacetCache::release(std::uint32_t id) {
    Corner& corner = corners_[id];
    if (--corner.users > 0) return;
    if (corner.shared_as != 0) shared_corners_.erase(corner.shared_as);
    Group& group = groups_[corner.group];
    std::erase(group.corners, id);
    if (corner.counted_spread >= 0.0f) {
        group.spread -= corner.counted_spread;
        --group.judged;
    }
    corner = Corner{.gone = true};
    released_.push_back(id);
}

void FacetCache::bury_released() {
    if (released_.empty()) return;
    const auto gone = [&](std::uint32_t corner) { return corners_[corner].gone; };
    std::erase_if(unfinished_, gone);
    std::erase_if(unmended_, gone);
    free_corners_.insert(free_corners_.end(), released_.begin(), released_.end());
    released_.clear();
}

float FacetCache::mean_irradiance() const {
    double sum = 0.0, lit = 0.0;
    for (const auto& [name, facet] : facets_) {
        const Corner& corner = corners_[facet.corners[0]];
        if (facet.depth > 0 || facet.stand_in || !corner.lit) continue;
        sum += luminance(corner.at.irradiance);
        ++lit;
    }
    return lit > 0.0 ? static_cast<float>(sum / lit) : 0.0f;
}

void FacetCache::split_where_needed() {
    // Not before light has settled: until then it would split where light has not arrived yet.
    if (splits_are_old_ && unfinished_.empty() && share_known() == 1.0f) look_again_at_splits();
    std::optional<float> known_mean;
    const auto mean = [&] { return known_mean ? *known_mean : known_mean.emplace(mean_irradiance()); };
    std::vector<FacetName> waiting;
    std::vector<Wanted> finer;
    for (const FacetName name : std::exchange(unsplit_, {})) {
        Facet& facet = facets_.at(name);
        if (facet.split || facet.depth >= facet_most_splits) continue;
        const bool fine = facet.depth >= smooth_splits, single = facet.cut && facet.depth > 0;
        float low = std::numeric_limits<float>::infinity(), high = 0.0f, sum = 0.0f;
        bool known = true;
        for (const std::uint32_t corner : facet.corners) {
            known &= corners_[corner].done;
            const float value = luminance(corners_[corner].at.irradiance);
            low = std::min(low, value);
            high = std::max(high, value);
            sum += 0.25f * value;
        }
        if (!known) {
            waiting.push_back(name);
            continue;
        }
        // What is finer still must be worth it: many times as bright as what else is seen.
        if (fine ? (facet.cut ? high : high - low) <= glaring * mean() : high - low <= smooth_contrast * sum) continue;
        facet.split = true;
        table_is_old_ = shown_are_old_ = true;
        if (single) {
            look_again_ = true;
            continue;
        }
        const Facet parent = facet;
        const vec2 within(facet_cell(parent.middle.position, parent.middle.normal(), parent.level).within);
        const std::vector<vec2> steps = steps_across_a_quarter(parent.middle);
        for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
            const vec2 centre = vec2(0.25f) + 0.5f * vec2(quarter & 1, quarter >> 1) - within;
            for (const vec2 step : steps) {
                const vec3 target = along_surface(parent.middle, parent.level, centre + step);
                if (const auto point = surface_near(world_->scene, parent.middle, target, std::exp2(parent.level))) finer.push_back({.point = *point, .level = parent.level - 1.0f, .root = parent.root, .depth = parent.depth + 1});
            }
        }
        finer.push_back({.point = parent.middle, .level = parent.level - 1.0f, .root = parent.root, .depth = parent.depth + 1});
    }
    add(finer);
    look_again_ |= std::ranges::any_of(finer, [&](const Wanted& it) { return facets_.at(facet_name(facet_cell(it.point.position, it.point.normal(), it.level))).split; });
    unsplit_.insert(unsplit_.end(), waiting.begin(), waiting.end());
}

}  // namespace sl
