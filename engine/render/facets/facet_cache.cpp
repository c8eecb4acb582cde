// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_cache.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cstring>

namespace sl {

namespace {

/// How much more time than its budget a frame gets where a quarter of what was met has no light: at the start, or somewhere
/// else altogether.
constexpr double dark_frames_take = 4.0;

}  // namespace

float FacetCache::update(const RenderScene& scene, const FrameParams& frame, const Facets& settings, const Budget& budget) {
    follow_changes(scene, frame, settings);
    if (memory_ > std::max(most_memory_, budget.memory) && unmended_.empty() && !patches_->mending()) forget_unseen();
    // What has changed must be known before anything else, whatever that takes.
    const Deadline deadline(budget.seconds * (much_is_dark() ? dark_frames_take : 1.0));
    if (std::memcmp(&seen_.clip_from_world, &frame.clip_from_world, sizeof(mat4)) != 0 || seen_.ray_up.w != frame.ray_up.w || seen_.ray_right.w != frame.ray_right.w ||
        spacing_ != settings.spacing) {
        looks_ = 0;
    }
    other_spacing_ = spacing_ != settings.spacing;
    seen_ = frame;
    spacing_ = settings.spacing;
    do {
        look_around(frame, settings, deadline);
        work(settings, deadline);
        split_where_needed();
    } while (deadline.none() && share_known() < 1.0f);
    // After a change of surfaces the old light stays until each place has some of the new: a picture that is late by some
    // frames, and not one that falls dark.
    if (renewing_ && !unfinished_.empty() && corners_[unfinished_.front()].at.by_chance.empty()) return share_known();
    renewing_ = false;
    if (table_is_old_) {
        fill_table();
        table_is_old_ = false;
        ++version_;
    }
    return share_known();
}

bool FacetCache::much_is_dark() const {
    const auto dark = static_cast<std::size_t>(std::ranges::count_if(unfinished_, [&](std::uint32_t corner) { return !corners_[corner].lit; }));
    return corners_.empty() || 4 * dark > corners_.size() - free_corners_.size();
}

float FacetCache::share_known() const {
    const auto corners = static_cast<float>(std::max<std::size_t>(corners_.size(), 1));
    const float links = 1.0f - static_cast<float>(unfinished_.size()) / corners;
    const bool settled = !reflecting_ && to_gather_ == 0 && unmended_.empty() && !patches_->mending() && stale_.empty();
    return links * (settled ? 1.0f : 0.99f);
}

void FacetCache::fill_table() {
    const auto lit = [&](std::uint32_t corner) { return corners_[corner].lit; };
    if (std::exchange(shown_are_old_, false)) {
        const bool some_dark = !std::ranges::all_of(unfinished_, lit);
        shown_.clear();
        for (const auto& [name, facet] : facets_) {
            // One that stands in does so as long as others are dark, and not past an edge or a wall, where other light is.
            if (facet.stand_in && (facet.cut || !some_dark)) continue;
            // Where there is no light yet, a coarser one stands in.
            if (std::ranges::all_of(facet.corners, lit)) shown_.push_back({.name = name, .corners = facet.corners, .split = facet.split});
        }
        table_.place(shown_);
    }
    irradiance_.resize(corners_.size());
    variance_.resize(corners_.size());
    struct Sums {
        double squares = 0.0, lit = 0.0;
        std::size_t memory = 0;
    };
    const auto part = [&](const tbb::blocked_range<std::size_t>& range, Sums sums) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const Corner& corner = corners_[i];
            irradiance_[i] = corner.lit ? corner.at.irradiance : vec3(0.0f);
            sums.memory += corner.at.memory();
            variance_[i] = corner.lit ? 0.0f : -1.0f;
            if (!corner.lit || corner.at.by_chance.empty()) continue;
            const Group& group = groups_[corner.group];
            const float usual = group.judged > 0 ? group.spread / static_cast<float>(group.judged) : 0.0f, links = static_cast<float>(corner.at.by_chance.size());
            variance_[i] = std::max(corner.spread, usual) / links;
            sums.squares += static_cast<double>(corner.spread / links);
            ++sums.lit;
        }
        return sums;
    };
    const auto both = [](const Sums& a, const Sums& b) { return Sums{a.squares + b.squares, a.lit + b.lit, a.memory + b.memory}; };
    const Sums sums = tbb::parallel_deterministic_reduce(tbb::blocked_range<std::size_t>(0, corners_.size(), 1024), Sums{}, part, both);
    error_ = sums.lit > 0.0 ? static_cast<float>(std::sqrt(sums.squares / sums.lit)) : 0.0f;
    memory_ = sums.memory + patches_->memory();
    if (!unfinished_.empty()) smoothing_.smooth(shown_, irradiance_, variance_);
    table_.light(shown_, irradiance_);
}

}  // namespace sl
