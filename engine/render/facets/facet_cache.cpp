// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_cache.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cstring>

namespace sl {

namespace {

/// How much more time than its budget a frame gets where much of what is in view has no light: at the start, or somewhere else
/// altogether. From a little up to this share.
constexpr double dark_frames_take = 4.0;
constexpr float much_dark = 0.15f;

double longer_in_the_dark(float dark, float a_little) {
    const float part = std::clamp((dark - a_little) / (much_dark - a_little), 0.0f, 1.0f);
    return glm::mix(1.0, dark_frames_take, static_cast<double>(part));
}

/// Of a frame's time, what light gets even where surfaces that came took all of it.
constexpr double least_work = 0.5;

/// Looks, each at every other square, that together meet all that a moving camera sees.
constexpr std::uint32_t looks_that_see_all = 2;

}  // namespace

float FacetCache::update(const RenderScene& scene, const FrameParams& frame, const Facets& settings, const Budget& budget) {
    times_.begin();
    Deadline deadline(budget.seconds);
    const Followed followed = follow_changes(scene, frame, settings, budget.seconds > 0.0);
    times_.done("follow changes");
    if (memory_ > std::max(most_memory_, budget.memory)) forget_unseen();
    times_.done("forget unseen");
    if (std::memcmp(&seen_.clip_from_world, &frame.clip_from_world, sizeof(mat4)) != 0 || seen_.ray_up.w != frame.ray_up.w || seen_.ray_right.w != frame.ray_right.w ||
        spacing_ != settings.spacing) {
        looks_ = 0;
        view_began_ = all_looks_;
    }
    other_spacing_ = spacing_ != settings.spacing;
    seen_ = frame;
    spacing_ = settings.spacing;
    if (followed == Followed::at_once) deadline = Deadline(budget.seconds);
    do {
        deadline.leave(least_work * budget.seconds);
        const float fresh = look_around(frame, settings, deadline, budget.longest_look);
        times_.done("look");
        // Not in a frame that took surfaces in as well: the next ones have the time.
        dark_ = dark();
        if (followed != Followed::in_passing) deadline.extend(longer_in_the_dark(std::max(fresh, dark_.black), a_little_dark));
        deadline.leave(least_work * budget.seconds);
        work(settings, deadline);
        split_where_needed();
        times_.done("split");
    } while (budget.seconds <= 0.0 && (share_known() < 1.0f || look_again_));
    // After a change of surfaces the old light stays until each place has some of the new: a picture that is late by some
    // frames, and not one that falls dark.
    if (renewing_ && !unfinished_.empty() && corners_[unfinished_.front()].at.by_chance.empty()) return share_known();
    renewing_ = false;
    if (table_is_old_) {
        fill_table();
        table_is_old_ = false;
        ++version_;
        times_.done("table");
    }
    return share_known();
}

bool FacetCache::in_view(const Group& group) const {
    // Until there were enough looks from where the camera is, those from where it was still count.
    return group.seen + (looks_ < looks_that_see_all ? looks_that_see_all : 0) > view_began_;
}

FacetCache::Dark FacetCache::dark() const {
    std::size_t seen = 0, unlit = 0, black = 0;
    for (const Group& group : groups_) seen += in_view(group) ? group.corners.size() : 0;
    for (const std::uint32_t number : unfinished_) {
        const Corner& corner = corners_[number];
        if (corner.lit || !in_view(groups_[corner.group])) continue;
        ++unlit;
        if (!corner.fine) ++black;
    }
    if (seen == 0) return {};
    return {.unlit = static_cast<float>(unlit) / static_cast<float>(seen), .black = static_cast<float>(black) / static_cast<float>(seen)};
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
            // One that stands in does so as long as others are dark. Past an edge its light is another surface's, which is
            // less wrong than none.
            if (facet.stand_in && !some_dark) continue;
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
