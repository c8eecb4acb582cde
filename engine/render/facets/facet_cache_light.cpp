// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_cache.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <utility>

namespace sl {

namespace {

constexpr std::uint32_t first_links = 32, least_links = 64;
/// Where nothing arrived at all, its spread tells nothing either.
constexpr std::uint32_t least_links_in_the_dark = 256;
/// What the mean variance of a group counts beside a corner's own.
constexpr float word_of_neighbours = 0.5f;
/// Share of a corner's links that surfaces may change without other light being seen.
constexpr float much_renewed = 0.25f;
/// Guides learn from so many times the links that they learned from before.
constexpr std::uint32_t learning_links_grow_by = 4;
/// Light between patches has settled when a reflection changes none by more than this share of their mean.
constexpr float settled = 1e-3f;
constexpr std::size_t most_reflections = 400, reflections_between = 2;
/// Work between two looks at the clock.
constexpr std::size_t groups_at_once = 8, corners_at_once = 64, patches_at_once = 64, reflections_at_once = 2048;

/// Where light is hardest to find, noise stays above what was asked for; who asks for less gets more rays there as well.
std::uint32_t most_links(const Facets& settings) {
    const float finer = Facets{}.noise / settings.noise;
    return static_cast<std::uint32_t>(2048.0f * std::clamp(finer * finer, 1.0f, 32.0f));
}

bool goes_on_for_ever(const Facets& settings) { return settings.bounces >= 64; }

}  // namespace

void FacetCache::work(const Facets& settings, const Deadline& deadline) {
    // What is missing goes before what is wrong, and that before what is rough.
    link_corners(settings, put_urgent_first(), first_links, 0.6, deadline);
    times_.done("first links");
    while (patches_->renewing() && !deadline.passed(0.7)) {
        patches_->renew(patches_at_once);
        light_moves();
    }
    times_.done("renew");
    mend(deadline);
    while (unmended_.empty() && !patches_->renewing() && !deadline.passed(0.6) && patches_->mend(patches_at_once)) light_moves();
    times_.done("mend");
    // Further bounces are more than what is still rough of the first.
    while (!deadline.passed(0.8) && patches_->grow(patches_at_once)) {
        while (patches_->dark()) patches_->renew(patches_at_once);
        light_moves();
    }
    while (!deadline.passed(0.8) && patches_->renew(patches_at_once)) light_moves();
    times_.done("grow");
    reflect(settings, deadline);
    times_.done("reflect");
    gather(settings, deadline);
    times_.done("gather");
    guide_corners();
    improve_guides(settings);
    put_urgent_first();
    times_.done("guide");
    link_corners(settings, unfinished_.size(), most_links(settings), 1.0, deadline);
    if (unfinished_.empty() && !reflecting_ && !patches_->mending() && to_gather_ == 0) look_for_other_lights(deadline);
    times_.done("links");
}

std::size_t FacetCache::put_urgent_first() {
    // What the camera sees goes before what it saw. Of that, those without links come first: nothing is refined before light
    // has gone round once.
    const auto urgency = [&](std::uint32_t number) -> std::size_t {
        const Corner& corner = corners_[number];
        if (!in_view(groups_[corner.group])) return 4;
        return !corner.at.by_chance.empty() ? 3 : corner.stands_in ? 0 : !corner.fine ? 1 : 2;
    };
    std::array<std::vector<std::uint32_t>, 5> by_urgency;
    for (const std::uint32_t corner : unfinished_) by_urgency[urgency(corner)].push_back(corner);
    unfinished_.clear();
    for (const auto& corners : by_urgency) unfinished_.insert(unfinished_.end(), corners.begin(), corners.end());
    return by_urgency[0].size() + by_urgency[1].size() + by_urgency[2].size();
}

void FacetCache::mend(const Deadline& deadline) {
    std::vector<Patches::Job> jobs;
    // A little even where no time is left, or frequent changes would never be followed.
    for (bool first = true; !unmended_.empty() && (first || !deadline.passed(0.6)); first = false) {
        const std::size_t count = std::min(unmended_.size(), corners_at_once);
        const std::vector<std::uint32_t> batch(unmended_.end() - static_cast<std::ptrdiff_t>(count), unmended_.end());
        unmended_.resize(unmended_.size() - count);
        jobs.clear();
        for (const std::uint32_t corner : batch) {
            if (!corners_[corner].gone) jobs.push_back({.point = &corners_[corner].at, .by_chance = 0, .seed = corners_[corner].at.guide != nullptr ? 0 : corner + 1});
        }
        patches_->mend(jobs);
        while (patches_->dark()) patches_->renew(patches_at_once);
        tbb::parallel_for(std::size_t{0}, batch.size(), [&](std::size_t i) { judge(batch[i]); });
        for (const std::uint32_t corner : batch) {
            GatherPoint& at = corners_[corner].at;
            if (static_cast<float>(at.renewed) > much_renewed * static_cast<float>(at.by_chance.size())) distrust_guide(corners_[corner].group);
        }
        light_moves();
        table_is_old_ = true;
    }
    if (unmended_.empty() && !patches_->mending()) patches_->forget_changes();
}

void FacetCache::light_moves() {
    reflecting_ = true;
    largest_change_ = std::numeric_limits<float>::infinity();
    to_gather_ = corners_.size();
}

void FacetCache::look_for_other_lights(const Deadline& deadline) {
    for (std::size_t i = 0; !stale_.empty() && (deadline.none() || i < groups_at_once); ++i) {
        const std::uint32_t number = stale_.back();
        stale_.pop_back();
        for (const std::uint32_t corner : groups_[number].corners) link_anew(corner, nullptr);
        groups_[number].guide.reset();
        groups_[number].stale = false;
        unguided_.push_back(number);
    }
}

void FacetCache::link_anew(std::uint32_t corner, const Guide* guide) {
    Corner& it = corners_[corner];
    // Its light stays until there is some of the new.
    it.at = {.point = it.at.point, .level = it.at.level, .guide = guide, .irradiance = it.at.irradiance};
    if (std::exchange(it.done, false)) unfinished_.push_back(corner);
}

void FacetCache::guide_corners() {
    const auto linked = [&](std::uint32_t corner) { return !corners_[corner].at.by_chance.empty(); };
    std::vector<std::uint32_t> waiting;
    for (const std::uint32_t number : std::exchange(unguided_, {})) {
        Group& group = groups_[number];
        if (!std::ranges::all_of(group.corners, linked)) {
            waiting.push_back(number);
            continue;
        }
        group.guide = std::make_unique<Guide>(patches_->guide_for(jobs_of(group)));
        group.tried = 0;
        if (!group.guide->empty()) untried_.push_back(number);
        // What was found by chance alone has done its duty.
        for (const std::uint32_t corner : group.corners) link_anew(corner, group.guide.get());
    }
    unguided_.insert(unguided_.end(), waiting.begin(), waiting.end());
}

void FacetCache::improve_guides(const Facets& settings) {
    std::vector<std::uint32_t> waiting;
    for (const std::uint32_t number : std::exchange(untried_, {})) {
        Group& group = groups_[number];
        if (group.guide == nullptr || group.guide->empty()) continue;
        // From few links, and again from more; where all have what they want there is nothing to gain.
        const auto wanted = std::max(learning_links_grow_by * group.tried, least_links / 2);
        bool done = true, linked = true;
        for (const std::uint32_t corner : group.corners) {
            done &= corners_[corner].done;
            linked &= corners_[corner].done || corners_[corner].at.guided.size() >= wanted;
        }
        if (done && !group.corners.empty()) continue;
        if (2 * wanted <= most_links(settings) / 2) waiting.push_back(number);
        if (!linked) continue;
        group.tried = wanted;
        if (!patches_->improve(*group.guide, jobs_of(group))) continue;
        for (const std::uint32_t corner : group.corners) link_anew(corner, group.guide.get());
    }
    untried_.insert(untried_.end(), waiting.begin(), waiting.end());
}

std::vector<Patches::Job> FacetCache::jobs_of(const Group& group) {
    std::vector<Patches::Job> jobs;
    for (const std::uint32_t corner : group.corners) jobs.push_back({.point = &corners_[corner].at, .by_chance = 0, .seed = 0});
    return jobs;
}

void FacetCache::link_corners(const Facets& settings, std::size_t count, std::uint32_t most, double share, const Deadline& deadline) {
    std::vector<Patches::Job> jobs;
    std::size_t done = 0;
    std::vector<std::uint32_t> again;
    while (done < count && !deadline.passed(share)) {
        jobs.clear();
        const std::size_t first = done;
        for (; done < count && jobs.size() < corners_at_once; ++done) {
            GatherPoint& at = corners_[unfinished_[done]].at;
            const auto known = static_cast<std::uint32_t>(at.by_chance.size());
            if (known >= most) continue;
            // The same directions at all corners: what they miss, neighbours miss alike, and no blotches arise. But while a
            // group looks for what matters, each looks elsewhere.
            const bool guided = at.guide != nullptr;
            jobs.push_back({.point = &at, .by_chance = std::max(2 * known, guided ? least_links : first_links), .seed = guided ? 0 : unfinished_[done] + 1});
        }
        again.insert(again.end(), unfinished_.begin() + static_cast<std::ptrdiff_t>(first), unfinished_.begin() + static_cast<std::ptrdiff_t>(done));
        if (jobs.empty()) break;
        patches_->link(jobs);
        while (patches_->dark()) patches_->renew(patches_at_once);
        light_moves();
        // At once, for what there is: until then a new place is dark.
        tbb::parallel_for(first, done, [&](std::size_t i) { judge(unfinished_[i]); });
        for (std::size_t i = first; i < done; ++i) decide(unfinished_[i], settings);
        table_is_old_ = true;
    }
    unfinished_.erase(unfinished_.begin(), unfinished_.begin() + static_cast<std::ptrdiff_t>(done));
    unfinished_.insert(unfinished_.end(), again.begin(), again.end());
}

void FacetCache::reflect(const Facets& settings, const Deadline& deadline) {
    if (!reflecting_) return;
    if (!goes_on_for_ever(settings)) {
        patches_->forget_reflections(settings.bounces > 0);
        for (std::uint32_t i = 1; i < settings.bounces; ++i) patches_->reflect(0, patches_->size());
        reflecting_ = false;
        to_gather_ = corners_.size();
        return;
    }
    // In turns, and over when a whole round has changed nothing that could be seen.
    const std::size_t slice = deadline.none() ? patches_->size() : reflections_at_once;
    // While light is still wrong a little of it goes on, or light that never rests would never be reflected.
    bool more = true;
    for (std::size_t rounds = 0; reflecting_ && more;) {
        more = !patches_->renewing() && !deadline.passed(0.9);
        const std::size_t last = std::min(reflected_ + slice, patches_->size());
        largest_change_ = std::max(largest_change_, patches_->reflect(reflected_, last));
        to_gather_ = corners_.size();
        reflected_ = last;
        if (reflected_ < patches_->size()) continue;
        reflected_ = 0;
        reflecting_ = std::exchange(largest_change_, 0.0f) > settled * patches_->mean_light();
        // Light settles when nothing else is left to do.
        if (++rounds == (unfinished_.empty() ? most_reflections : reflections_between)) break;
    }
}

void FacetCache::gather(const Facets& settings, const Deadline& deadline) {
    const std::size_t all = corners_.size();
    for (bool first = true; to_gather_ > 0 && (first || !deadline.passed()); first = false) {
        const std::size_t batch = std::min(to_gather_, 4 * corners_at_once);
        tbb::parallel_for(std::size_t{0}, batch, [&](std::size_t i) { judge(static_cast<std::uint32_t>((gathered_ + i) % all)); });
        for (std::size_t i = 0; i < batch; ++i) decide(static_cast<std::uint32_t>((gathered_ + i) % all), settings);
        gathered_ = (gathered_ + batch) % all;
        to_gather_ -= batch;
        table_is_old_ = true;
    }
    std::erase_if(unfinished_, [&](std::uint32_t corner) { return corners_[corner].done; });
}

void FacetCache::judge(std::uint32_t corner) {
    Corner& it = corners_[corner];
    if (it.gone || it.at.by_chance.empty()) return;
    const Patches::Gathered gathered = patches_->gather(it.at);
    it.at.irradiance = gathered.irradiance;
    // Others may say the same at the same time.
    if (!std::exchange(it.lit, true)) std::atomic_ref(shown_are_old_).store(true, std::memory_order_relaxed);
    const float mean = luminance(gathered.irradiance), relative = mean > 0.0f ? gathered.error / mean : 0.0f;
    it.spread = relative * relative * static_cast<float>(it.at.by_chance.size());
}

void FacetCache::decide(std::uint32_t corner, const Facets& settings) {
    Corner& it = corners_[corner];
    // Without a guide it may have missed the brightest thing.
    if (it.gone || it.at.guide == nullptr || it.at.by_chance.empty()) return;
    // What has missed the brightest so far seems dark and sure of it: its neighbours know better.
    Group& group = groups_[it.group];
    if (it.counted_spread < 0.0f) ++group.judged;
    group.spread += it.spread - std::max(it.counted_spread, 0.0f);
    it.counted_spread = it.spread;
    const std::size_t links = it.at.by_chance.size();
    const float spread = std::max(it.spread, word_of_neighbours * group.spread / static_cast<float>(group.judged));
    const bool dark = !(luminance(it.at.irradiance) > 0.0f);
    it.done = it.done || (links >= (dark ? least_links_in_the_dark : least_links) && (!it.to_stay || spread <= settings.noise * settings.noise * static_cast<float>(links) || links >= most_links(settings)));
}

}  // namespace sl
