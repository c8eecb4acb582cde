// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_cache.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sl {

namespace {

/// Of the scene's size: where more of it has changed, nothing is worth keeping.
constexpr float most_changed = 0.5f;

/// What all that was traced depends on.
std::uint64_t materials_of(const RenderScene& scene) { return hash_bytes(hash_mix(1, scene.materials_hash), &scene.origin, sizeof(dvec3)); }

}  // namespace

void FacetCache::follow_changes(const RenderScene& scene, const FrameParams& frame, const Facets& settings) {
    const std::uint64_t materials = materials_of(scene), surfaces = scene.geometry_hash();
    if (!world_ || materials != materials_) {
        materials_ = materials;
        start_anew(scene);
    } else {
        if (surfaces != surfaces_) {
            if (const Bounds box = changed_surfaces(scene); !box.empty()) change_surfaces(scene, frame, settings, box);
        }
        if (lights_ != scene.lights || world_->sky != scene.sky_radiance) change_lights(scene);
    }
    if (std::exchange(surfaces_, surfaces) != surfaces || draws_.empty()) {
        draws_.clear();
        for (const RenderScene::Draw& draw : scene.draws) draws_[draw.content] = draw.bounds;
    }
    lights_ = scene.lights;
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

void FacetCache::start_anew(const RenderScene& scene) {
    renewing_ = table_.slots > 0;
    patches_.reset();
    world_ = std::make_unique<TransportWorld>(scene, TransportSettings{});
    patches_ = std::make_unique<Patches>(*world_);
    lights_ = scene.lights;
    facets_.clear();
    shared_corners_.clear();
    corners_.clear();
    unfinished_.clear();
    unsplit_.clear();
    group_of_cell_.clear();
    groups_.clear();
    unguided_.clear();
    untried_.clear();
    stale_.clear();
    gathered_ = to_gather_ = 0;
    reflecting_ = false;
    reflected_ = 0;
    looks_ = 0;
    table_is_old_ = true;
}

Bounds FacetCache::changed_surfaces(const RenderScene& scene) const {
    Bounds result;
    std::unordered_map<std::uint64_t, Bounds> left = draws_;
    for (const RenderScene::Draw& draw : scene.draws) {
        if (left.erase(draw.content) > 0) continue;
        // Of a mesh that was edited once, only the edited part is another one.
        const bool edited = !draw.changed.empty() && left.erase(draw.content_before) > 0;
        result.add(edited ? draw.changed : draw.bounds);
    }
    for (const auto& [content, bounds] : left) result.add(bounds);
    return result;
}

void FacetCache::change_surfaces(const RenderScene& scene, const FrameParams& frame, const Facets& settings, const Bounds& box) {
    if (box.radius() > most_changed * scene.bounds.radius()) return start_anew(scene);
    auto world = std::make_unique<TransportWorld>(scene, TransportSettings{});
    // Lights are another change.
    world->lights = world_->lights;
    world->casts = world_->casts;
    world->bounces = world_->bounces;
    world->sky = world_->sky;
    world_.swap(world);
    const Bounds without_facets = forget_facets(box);
    std::vector<Patches::Job> points;
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
        if (!corners_[i].gone) points.push_back({.point = &corners_[i].at, .by_chance = 0, .seed = corners_[i].at.guide != nullptr ? 0 : i + 1});
    }
    patches_->change(*world_, box, points);
    const auto before = world->emitters.balls(), now = world_->emitters.balls();
    std::vector<Emitters::Ball> glowing;
    std::ranges::copy_if(before, std::back_inserter(glowing), [&](const auto& ball) { return std::ranges::find(now, ball) == now.end(); });
    std::ranges::copy_if(now, std::back_inserter(glowing), [&](const auto& ball) { return std::ranges::find(before, ball) == before.end(); });
    if (!glowing.empty()) patches_->forget_light(glowing);
    // What is seen of the changed part, at once: there must be no holes.
    look_at(frame, settings, without_facets);
    light_has_changed();
}

Bounds FacetCache::forget_facets(const Bounds& box) {
    Bounds without = box;
    std::erase_if(facets_, [&](const auto& entry) {
        const vec3 middle = entry.second.middle.position;
        const float side = std::exp2(entry.second.level);
        if (!box.grown(1.5f * side).contains(middle)) return false;
        without.add(middle - side);
        without.add(middle + side);
        return true;
    });
    std::erase_if(unsplit_, [&](FacetName name) { return !facets_.contains(name); });
    for (Corner& corner : corners_) corner.gone = corner.gone || box.contains(corner.at.point.position);
    const auto gone = [&](std::uint32_t corner) { return corners_[corner].gone; };
    std::erase_if(unfinished_, gone);
    std::erase_if(shared_corners_, [&](const auto& entry) { return box.grown(2.0f * std::exp2(corners_[entry.second].at.level)).contains(corners_[entry.second].at.point.position); });
    for (Group& group : groups_) std::erase_if(group.corners, gone);
    table_is_old_ = true;
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
    light_has_changed();
}

void FacetCache::light_has_changed() {
    light_moves();
    // Guides know nothing of light that is new.
    stale_.clear();
    for (std::uint32_t group = 0; group < groups_.size(); ++group) {
        if (groups_[group].guide) stale_.push_back(group);
    }
    for (const auto& [name, facet] : facets_) {
        if (!facet.split) unsplit_.push_back(name);
    }
}

}  // namespace sl
