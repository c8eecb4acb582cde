// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_cache.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

#include "engine/render/facets/merged_boxes.h"

namespace sl {

namespace {

/// Of the surfaces that were there, judged by the boxes round them: where more went, or so many times as much came, nothing
/// is worth keeping.
constexpr float most_lost = 0.5f, most_came = 2.0f;
/// Changes elsewhere in one frame that are followed as such, and corners that follow in order of what they see of them.
constexpr std::size_t most_boxes = 64, most_urgent = 4096;
/// How many frames changes that hardly show wait for others: following many costs little more than following one.
constexpr std::uint32_t frames_to_wait = 8;
/// Looks at what came of itself: one meets nearly all of it, and a camera that moves looks again in the next frame.
constexpr std::uint32_t looks_in_passing = 4;

/// Points whose links are looked at in a frame, so that places of patches that are gone can be taken.
constexpr std::size_t points_at_once = 4096;

/// m: what a move of the origin changes a position by beyond itself, and how far it goes before nothing worth keeping is left.
constexpr float rounding = 1e-3f, farthest_move = 1e5f;

/// What was not seen for so many looks may be forgotten, where it is that share of all facets.
constexpr std::uint32_t looks_kept = 600;
constexpr float worth_forgetting = 0.25f;

float surface(const std::vector<RenderScene::Draw>& draws) {
    return std::transform_reduce(draws.begin(), draws.end(), 0.0f, std::plus(), [](const RenderScene::Draw& draw) { return half_surface(draw.bounds); });
}

}  // namespace

FacetCache::Followed FacetCache::follow_changes(const RenderScene& scene, const FrameParams& frame, const Facets& settings, bool may_wait) {
    const vec3 offset(std::exchange(origin_, scene.origin) - scene.origin);
    const bool same_materials = std::exchange(materials_, scene.materials_hash) == scene.materials_hash;
    Followed followed = Followed::nothing;
    if (!world_ || !same_materials || !move(offset, scene.lights)) {
        start_anew(scene);
        followed = Followed::at_once;
    } else {
        followed = follow_surfaces(scene, frame, settings, may_wait);
        // A frame has time for one of both, but who edits sees all of it at once.
        const bool may_be_late = may_wait && followed == Followed::in_passing && !lights_wait_;
        lights_wait_ = (lights_ != scene.lights || world_->sky != scene.sky_radiance) && may_be_late;
        if (!lights_wait_) follow_lights(scene);
        bury_some(!may_wait);
    }
    follow_settings(settings);
    return followed;
}

void FacetCache::follow_settings(const Facets& settings) {
    if (settings.noise < noise_) {
        for (std::uint32_t i = 0; i < corners_.size(); ++i) {
            if (!corners_[i].gone && std::exchange(corners_[i].done, false)) unfinished_.push_back(i);
        }
        to_gather_ = corners_.size();
    }
    noise_ = settings.noise;
    if (settings.bounces != bounces_) {
        patches_->forget_reflections(settings.bounces > 0);
        light_moves();
    }
    bounces_ = settings.bounces;
}

FacetCache::Followed FacetCache::follow_surfaces(const RenderScene& scene, const FrameParams& frame, const Facets& settings, bool may_wait) {
    const std::uint64_t surfaces = scene.geometry_hash();
    if (surfaces == surfaces_) {
        waited_ = 0;
        return Followed::nothing;
    }
    bool edited = !may_wait;
    std::vector<Bounds> boxes, showing;
    float came = 0.0f, lost = 0.0f;
    for (const SurfaceChanges::Change& change : changes_.since_last_look(scene)) {
        boxes.push_back(change.box);
        (change.came ? came : lost) += half_surface(change.box);
        edited |= change.edited;
        if (!may_wait || change.edited || !hardly_shows(change.box, vec3(frame.camera_position))) showing.push_back(change.box);
    }
    waited_ = showing.empty() && waited_ < frames_to_wait ? waited_ + 1 : 0;
    if (waited_ > 0) return Followed::nothing;
    const float stays = surface(scene.draws) - came;
    if (lost > most_lost * (stays + lost) || came > most_came * (stays + lost)) {
        start_anew(scene);
        return Followed::at_once;
    }
    surfaces_ = surfaces;
    if (boxes.empty()) {
        changes_.look_at(scene);
        return Followed::nothing;
    }
    std::vector<Bounds> holes = change_surfaces(scene, merged_boxes(boxes, most_boxes));
    changes_.look_at(scene);
    // There must be none that show. Others are found in time, also by a camera that stands still.
    std::erase_if(holes, [&](const Bounds& hole) { return std::ranges::none_of(showing, [&](const Bounds& box) { return box.touches(hole); }); });
    if (!holes.empty()) look_at(frame, settings, holes, edited ? all_looks(settings) : looks_in_passing);
    looks_ = 0;
    return edited ? Followed::at_once : Followed::in_passing;
}

void FacetCache::follow_lights(const RenderScene& scene) {
    if (lights_ != scene.lights || world_->sky != scene.sky_radiance) change_lights(scene);
    lights_ = scene.lights;
}

bool FacetCache::move(vec3 offset, const std::vector<RenderScene::Light>& lights) {
    if (offset == vec3(0.0f)) return true;
    const vec3 cells = offset * std::exp2(-static_cast<float>(coarsest_cell()));
    if (cells != glm::round(cells) || glm::length(offset) > farthest_move) return false;
    world_->move(offset);
    patches_->move(offset);
    changes_.move(offset);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        if (lights_[i].kind == RenderScene::Light::Kind::directional) continue;
        lights_[i].position += offset;
        if (i < lights.size() && glm::length(lights[i].position - lights_[i].position) < rounding) lights_[i].position = lights[i].position;
    }
    for (Corner& corner : corners_) {
        corner.at.point.position += offset;
        if (corner.shared_as != 0) corner.shared_as = facet_name_moved(corner.shared_as, offset);
    }
    for (Group& group : groups_) {
        if (group.cell != 0) group.cell = facet_name_moved(group.cell, offset);
        if (!group.guide) continue;
        for (Guide::Target& target : group.guide->targets) target.place += offset;
    }
    for (auto& [name, facet] : facets_) {
        facet.middle.position += offset;
        facet.root = facet_name_moved(facet.root, offset);
    }
    for (FacetName& name : unsplit_) name = facet_name_moved(name, offset);
    move_names(facets_, offset);
    move_names(shared_corners_, offset);
    move_names(group_of_cell_, offset);
    // What it holds lies elsewhere now.
    renewing_ = false;
    table_is_old_ = shown_are_old_ = true;
    return true;
}

int FacetCache::coarsest_cell() const {
    int level = patches_->coarsest_cell();
    const auto look_at = [&](const auto& entries) {
        for (const auto& [name, value] : entries) level = std::max(level, facet_level_of(name));
    };
    look_at(facets_);
    look_at(shared_corners_);
    look_at(group_of_cell_);
    return level;
}

void FacetCache::start_anew(const RenderScene& scene) {
    renewing_ = table_.slots > 0;
    patches_.reset();
    // Normal textures are finer than facets, whose names hold the way a surface faces.
    world_ = std::make_unique<TransportWorld>(scene, TransportSettings{.relief = Relief::flat});
    patches_ = std::make_unique<Patches>(*world_);
    lights_ = scene.lights;
    lights_wait_ = false;
    surfaces_ = scene.geometry_hash();
    changes_.look_at(scene);
    facets_.clear();
    shared_corners_.clear();
    corners_.clear();
    released_.clear();
    free_corners_.clear();
    free_groups_.clear();
    most_memory_ = 0;
    unfinished_.clear();
    unsplit_.clear();
    group_of_cell_.clear();
    groups_.clear();
    unguided_.clear();
    untried_.clear();
    unmended_.clear();
    stale_.clear();
    gathered_ = to_gather_ = 0;
    reflecting_ = false;
    reflected_ = 0;
    looks_ = 0;
    waited_ = 0;
    splits_are_old_ = false;
    table_is_old_ = shown_are_old_ = true;
}

std::vector<Bounds> FacetCache::change_surfaces(const RenderScene& scene, const std::vector<Bounds>& boxes) {
    const auto before = world_->emitters.balls();
    // Lights are another change.
    world_->resurface(scene);
    patches_->change(boxes);
    const auto now = world_->emitters.balls();
    std::vector<Emitters::Ball> glowing;
    std::ranges::copy_if(before, std::back_inserter(glowing), [&](const auto& ball) { return std::ranges::find(now, ball) == now.end(); });
    std::ranges::copy_if(now, std::back_inserter(glowing), [&](const auto& ball) { return std::ranges::find(before, ball) == before.end(); });
    if (!glowing.empty()) patches_->forget_light(glowing);
    std::vector<Bounds> holes = forget_facets(boxes);
    mend_later(boxes);
    light_moves();
    splits_are_old_ = true;
    return holes;
}

void FacetCache::mend_later(const std::vector<Bounds>& boxes) {
    unmended_.clear();
    std::vector<float> concern(corners_.size());
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
        if (corners_[i].gone || corners_[i].at.by_chance.empty()) continue;
        unmended_.push_back(i);
        // About the part of its view that they fill.
        for (const Bounds& box : boxes) {
            const vec3 offset = box.centre() - corners_[i].at.point.position;
            const float part = box.radius() * box.radius() / std::max(glm::dot(offset, offset), std::numeric_limits<float>::min());
            if (part > 0.0f) concern[i] += part;  // NaN would have no order
        }
    }
    const std::size_t urgent = std::min(unmended_.size(), most_urgent);
    const auto less = [&](std::uint32_t a, std::uint32_t b) { return concern[a] < concern[b]; };
    std::ranges::nth_element(unmended_, unmended_.end() - static_cast<std::ptrdiff_t>(urgent), less);
    std::sort(unmended_.end() - static_cast<std::ptrdiff_t>(urgent), unmended_.end(), less);
}

std::vector<Bounds> FacetCache::forget_facets(const std::vector<Bounds>& boxes) {
    std::vector<Bounds> without = boxes;
    const auto touched = [&](Facet& facet, const Bounds& box, Bounds& empty) {
        const float side = std::exp2(facet.level);
        if (!box.grown(2.5f * side).contains(facet.middle.position)) return false;
        const vec2 within(facet_cell(facet.middle.position, facet.middle.normal(), facet.level).within);
        const vec3 centre = along_surface(facet.middle, facet.level, 0.5f - within);
        if (!box.grown(0.75f * side).contains(centre)) return false;
        const bool lost = box.contains(facet.middle.position) || std::ranges::any_of(facet.corners, [&](std::uint32_t corner) { return box.contains(corners_[corner].at.point.position); });
        // Much larger ones have their corners where they had them, and finer ones are asked for where those differ, or by what
        // is seen of them where they are cut.
        if (!lost && side > 2.0f * box.radius()) {
            facet.split = facet.cut && facet.split;
            return false;
        }
        empty.add(centre - 0.75f * side);
        empty.add(centre + 0.75f * side);
        return true;
    };
    const auto forgotten = [&](Facet& facet) {
        bool any = false;
        for (std::size_t i = 0; i < boxes.size(); ++i) any |= touched(facet, boxes[i], without[i]);
        if (!any) return false;
        for (const std::uint32_t corner : facet.corners) release(corner);
        return true;
    };
    for (auto it = facets_.begin(); it != facets_.end();) it = forgotten(it->second) ? facets_.erase(it) : std::next(it);
    std::erase_if(unsplit_, [&](FacetName name) { return !facets_.contains(name); });
    // What stands beside a corner now may keep others from sharing it.
    for (Corner& corner : corners_) {
        if (corner.shared_as == 0) continue;
        const auto beside = [&](const Bounds& box) { return box.grown(0.2f * std::exp2(corner.at.level)).contains(corner.at.point.position); };
        if (std::ranges::any_of(boxes, beside)) shared_corners_.erase(std::exchange(corner.shared_as, 0));
    }
    bury_released();
    table_is_old_ = shown_are_old_ = true;
    return without;
}

void FacetCache::change_lights(const RenderScene& scene) {
    const std::vector<LightParams> before = world_->lights;
    world_->relight(scene);
    // What a light did where it was, and what it does where it is.
    std::vector<LightParams> changed;
    const auto all_but = [&](const auto& lights, const auto& params, const auto& same) {
        for (std::size_t i = 0; i < lights.size(); ++i) {
            if (std::ranges::find(same, lights[i]) == same.end()) changed.push_back(params[i]);
        }
    };
    all_but(lights_, before, scene.lights);
    all_but(scene.lights, world_->lights, lights_);
    patches_->forget_light(changed);
    light_moves();
    // Guides know nothing of light that is new.
    for (std::uint32_t group = 0; group < groups_.size(); ++group) distrust_guide(group);
    splits_are_old_ = true;
}

void FacetCache::look_again_at_splits() {
    splits_are_old_ = false;
    unsplit_.clear();
    for (const auto& [name, facet] : facets_) {
        if (!facet.split && !facet.stand_in) unsplit_.push_back(name);
    }
}

void FacetCache::forget_unseen() {
    std::vector<FacetName> unseen;
    for (const auto& [name, facet] : facets_) {
        const auto root = facets_.find(facet.root);
        if (root == facets_.end() || all_looks_ - root->second.seen > looks_kept) unseen.push_back(name);
    }
    if (unseen.size() < worth_forgetting * static_cast<float>(facets_.size())) {
        most_memory_ = memory_ + memory_ / 4;
        return;
    }
    for (const FacetName name : unseen) {
        const auto facet = facets_.find(name);
        for (const std::uint32_t corner : facet->second.corners) release(corner);
        facets_.erase(facet);
    }
    std::erase_if(unsplit_, [&](FacetName name) { return !facets_.contains(name); });
    bury_released();
    forget_empty_groups();
    const std::vector<const GatherPoint*> points = gather_points();
    patches_->forget_all_but_seen_from(points);
    memory_ = patches_->memory();
    for (const GatherPoint* point : points) memory_ += point->memory();
    // Twice as much: so rarely that all of this costs little of what has come since.
    most_memory_ = 2 * memory_;
    table_is_old_ = shown_are_old_ = true;
}

void FacetCache::bury_some(bool all) {
    if (!patches_->burying()) {
        if (!patches_->many_gone()) return;
        patches_->begin_burying();
        buried_ = 0;
    }
    bool more = true;
    for (bool first = true; more && (first || all); first = false) {
        if (buried_ == corners_.size()) {
            more = patches_->bury(points_at_once);
            continue;
        }
        const std::size_t last = std::min(buried_ + points_at_once, corners_.size());
        tbb::parallel_for(buried_, last, [&](std::size_t corner) { patches_->keep_linked(corners_[corner].at); });
        buried_ = last;
    }
}

std::vector<const GatherPoint*> FacetCache::gather_points() const {
    std::vector<const GatherPoint*> points;
    for (const Corner& corner : corners_) {
        if (!corner.gone) points.push_back(&corner.at);
    }
    return points;
}

void FacetCache::forget_empty_groups() {
    for (std::uint32_t number = 0; number < groups_.size(); ++number) {
        Group& group = groups_[number];
        if (group.cell == 0 || !group.corners.empty()) continue;
        group_of_cell_.erase(group.cell);
        group = {};
        free_groups_.push_back(number);
    }
    for (std::vector<std::uint32_t>* list : {&unguided_, &untried_, &stale_}) std::erase_if(*list, [&](std::uint32_t number) { return groups_[number].cell == 0; });
}

void FacetCache::distrust_guide(std::uint32_t group) {
    if (groups_[group].guide && !std::exchange(groups_[group].stale, true)) stale_.push_back(group);
}

}  // namespace sl
