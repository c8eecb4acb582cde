// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_cache.h"

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
    const bool some_dark = std::ranges::any_of(unfinished_, [&](std::uint32_t corner) { return !corners_[corner].lit; });
    std::vector<FacetEntry> entries;
    entries.reserve(facets_.size());
    for (const auto& [name, facet] : facets_) {
        // Where there is no light yet, a coarser one stands in.
        if (std::ranges::any_of(facet.corners, [&](std::uint32_t corner) { return !corners_[corner].lit; })) continue;
        // One that stands in does so as long as others are dark, and not past an edge or a wall, where other light is.
        if (facet.stand_in && (facet.cut || !some_dark)) continue;
        FacetEntry& entry = entries.emplace_back(FacetEntry{.name = name, .irradiance = {}, .split = facet.split});
        for (std::size_t corner = 0; corner < 4; ++corner) entry.irradiance[corner] = corners_[facet.corners[corner]].at.irradiance;
    }
    table_.fill(entries);
    double squares = 0.0, lit = 0.0;
    for (const Corner& corner : corners_) {
        if (!corner.lit || corner.at.by_chance.empty()) continue;
        squares += static_cast<double>(corner.spread) / static_cast<double>(corner.at.by_chance.size());
        ++lit;
    }
    error_ = lit > 0.0 ? static_cast<float>(std::sqrt(squares / lit)) : 0.0f;
}

}  // namespace sl
