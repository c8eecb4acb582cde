// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_cache.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

#include "engine/render/facets/facet_corner.h"

namespace sl {

namespace {

/// Pixels, per side of a square of the picture, through which the camera's rays go in as many looks.
constexpr std::uint32_t most_looks_per_side = 8;
/// The cosine of the angle under which facets are seen whole, and how many levels coarser a shader searches.
constexpr float steep = 0.25f, coarser_that_are_searched = 3.0f;
constexpr std::uint32_t most_depth = 3;
/// Corners that differ by this share of their mean get finer facets between them.
constexpr float smooth_contrast = 0.25f;
/// A group of corners lies in a square of 8 by 8 facets.
constexpr float group_level = 3.0f;
constexpr std::uint32_t first_links = 32, least_links = 64, most_links = 2048;
/// Where nothing arrived at all, its spread tells nothing either.
constexpr std::uint32_t least_links_in_the_dark = 256;
/// Light between patches has settled when a reflection changes none by more than this share of their mean.
constexpr float settled = 1e-3f;
constexpr std::size_t most_reflections = 400, reflections_between = 2;
/// Work between two looks at the clock.
/// Of the scene's size: where more of it has changed, nothing is worth keeping.
constexpr float most_changed = 0.5f;
const Bounds everywhere{vec3(std::numeric_limits<float>::lowest()), vec3(std::numeric_limits<float>::max())};
constexpr std::uint32_t looks_at_once = 5;
/// Share of a look that meets facets which are not known yet, where the camera has not moved but jumped.
constexpr float elsewhere = 0.02f;
constexpr std::size_t groups_at_once = 8, corners_at_once = 64, patches_at_once = 64, reflections_at_once = 2048;

float luminance(vec3 colour) { return glm::dot(colour, vec3(0.2126f, 0.7152f, 0.0722f)); }

std::uint32_t looks_per_side(const Facets& settings) {
    return std::clamp(static_cast<std::uint32_t>(std::ceil(settings.spacing)), 1u, most_looks_per_side);
}

/// Where in its square a look goes, in [0, 1)²: each part of a grid once, neighbours far apart in time.
vec2 place_of_look(std::uint32_t look, std::uint32_t per_side) {
    std::uint32_t stride = std::max(5 * per_side / 8, 1u);
    while (std::gcd(stride, per_side) != 1) ++stride;
    const std::uint32_t row = look / per_side, column = (look + row) * stride % per_side;
    return (vec2(column, row * stride % per_side) + 0.5f) / static_cast<float>(per_side);
}

/// What all that was traced depends on.
std::uint64_t materials_of(const RenderScene& scene) { return hash_bytes(hash_mix(1, scene.materials_hash), &scene.origin, sizeof(dvec3)); }

bool goes_on_for_ever(const Facets& settings) { return settings.bounces >= 64; }

}  // namespace

float facet_side_over_distance(const FrameParams& frame, const Facets& settings) {
    return settings.spacing * 2.0f * glm::length(vec3(frame.ray_up)) / frame.ray_up.w;
}

/// When the time of a frame is up.
class FacetCache::Deadline {
  public:
    explicit Deadline(double seconds) : seconds_(seconds) {}
    bool none() const { return seconds_ <= 0.0; }
    /// Whether more than this share of the time is spent.
    bool passed(double share = 1.0) const {
        return !none() && std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() > share * seconds_;
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    double seconds_;
};

float FacetCache::update(const RenderScene& scene, const FrameParams& frame, const Facets& settings, const Budget& budget) {
    const Deadline deadline(budget.seconds);
    follow_changes(scene, frame, settings);
    if (std::memcmp(&seen_.clip_from_world, &frame.clip_from_world, sizeof(mat4)) != 0 || seen_.ray_up.w != frame.ray_up.w || seen_.ray_right.w != frame.ray_right.w ||
        spacing_ != settings.spacing) {
        looks_ = 0;
    }
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

float FacetCache::share_known() const {
    const auto corners = static_cast<float>(std::max<std::size_t>(corners_.size(), 1));
    const float links = 1.0f - static_cast<float>(unfinished_.size()) / corners, light = 1.0f - static_cast<float>(to_gather_) / corners;
    return std::min(links, light) * (reflecting_ || patches_->mending() || !stale_.empty() ? 0.99f : 1.0f);
}

void FacetCache::follow_changes(const RenderScene& scene, const FrameParams& frame, const Facets& settings) {
    const std::uint64_t materials = materials_of(scene);
    if (!world_ || materials != materials_) {
        materials_ = materials;
        start_anew(scene);
    } else {
        if (const Bounds box = changed_surfaces(scene); !box.empty()) change_surfaces(scene, frame, settings, box);
        if (lights_ != scene.lights || world_->sky != scene.sky_radiance) change_lights(scene);
    }
    draws_.clear();
    for (const RenderScene::Draw& draw : scene.draws) draws_[draw.content] = draw.bounds;
    lights_ = scene.lights;
    if (settings.noise < noise_) {
        for (std::uint32_t i = 0; i < corners_.size(); ++i) {
            if (std::exchange(corners_[i].done, false)) unfinished_.push_back(i);
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
    facets_.clear();
    shared_corners_.clear();
    corners_.clear();
    unfinished_.clear();
    unsplit_.clear();
    group_of_cell_.clear();
    groups_.clear();
    unguided_.clear();
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
    for (std::uint32_t i = 0; i < looks_per_side(settings) * looks_per_side(settings); ++i) look(frame, settings, i, without_facets);
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

void FacetCache::look_around(const FrameParams& frame, const Facets& settings, const Deadline& deadline) {
    // After so many, all that a still camera sees has been met. One that moves meets little that is new, and looks again in
    // the next frame; unless it is somewhere else altogether.
    const std::uint32_t all = looks_per_side(settings) * looks_per_side(settings);
    std::uint32_t most = looks_ == 0 ? 1 : looks_at_once;
    for (std::uint32_t i = 0; i < most && looks_ < all && !deadline.passed(0.3); ++i) {
        const float fresh = look(frame, settings, looks_++, everywhere);
        if (deadline.none() && fresh > elsewhere) most = all;
    }
}

float FacetCache::look(const FrameParams& frame, const Facets& settings, std::uint32_t number, const Bounds& where) {
    const vec2 size(frame.ray_right.w, frame.ray_up.w);
    const float spacing = std::max(settings.spacing, 1.0f);
    const uvec2 count(glm::ceil(size / spacing));
    const float side = facet_side_over_distance(frame, settings);
    const vec2 within = place_of_look(number, looks_per_side(settings));
    struct Seen {
        SurfacePoint point;
        std::array<float, 3> levels;
    };
    std::vector<std::optional<Seen>> unknown(std::size_t{count.x} * count.y);
    tbb::parallel_for(std::size_t{0}, unknown.size(), [&](std::size_t i) {
        const vec2 pixel = glm::min(glm::floor((vec2(i % count.x, i / count.x) + within) * spacing), size - 1.0f), at = (pixel + 0.5f) / size;
        const Ray ray{.origin = vec3(frame.camera_position), .direction = view_ray(frame, vec2(2.0f * at.x - 1.0f, 1.0f - 2.0f * at.y)), .nearest = frame.camera_position.w};
        if (!where.meets(ray.origin, ray.direction, std::numeric_limits<float>::infinity())) return;
        const auto hit = world_->scene.intersect_front(ray);
        if (!hit) return;
        const SurfacePoint point = world_->scene.surface_at(*hit);
        const vec3 offset = point.position - vec3(frame.camera_position);
        const float distance = glm::length(offset);
        // Pixels beside this one are a little nearer or farther off: where the level changes they want the other one.
        const float near = facet_level(distance * 0.93f, side), far = facet_level(distance * 1.07f, side);
        // Seen from the side, facets are narrower than pixels, and few of them are met: larger ones stand in for the others.
        const float slant = std::abs(glm::dot(offset, point.face)) / distance;
        const float coarse = far + std::clamp(std::ceil(std::log2(steep / std::max(slant, 1e-3f))), 0.0f, coarser_that_are_searched);
        for (const float level : {near, far, coarse}) {
            if (!facets_.contains(facet_name(facet_cell(point.position, point.normal(), level)))) unknown[i] = Seen{point, {near, far, coarse}};
        }
    });
    const auto known = static_cast<std::ptrdiff_t>(unfinished_.size());
    std::size_t fresh = 0;
    for (const auto& seen : unknown) {
        if (!seen) continue;
        ++fresh;
        for (const float level : seen->levels) add(seen->point, level, 0);
    }
    // All over the picture rather than from its top down: where the time of a frame ends, there is some light everywhere.
    std::sort(unfinished_.begin() + known, unfinished_.end(), [](std::uint32_t a, std::uint32_t b) { return a * 0x9e3779b1u < b * 0x9e3779b1u; });
    return static_cast<float>(fresh) / static_cast<float>(unknown.size());
}

void FacetCache::add(const SurfacePoint& point, float level, std::uint32_t depth) {
    const FacetCell cell = facet_cell(point.position, point.normal(), level);
    const FacetName name = facet_name(cell);
    const auto [entry, fresh] = facets_.try_emplace(name);
    if (!fresh) return;
    Facet& facet = entry->second;
    facet.middle = point;
    facet.level = level;
    facet.depth = depth;
    for (std::uint32_t corner = 0; corner < 4; ++corner) facet.corners[corner] = corner_of(facet, name, vec2(cell.within), uvec2(corner & 1, corner >> 1));
    unsplit_.push_back(name);
    table_is_old_ = true;
}

std::uint32_t FacetCache::corner_of(Facet& facet, FacetName name, vec2 within, uvec2 lattice) {
    // Facets that meet at a corner share it, unless it lies in an edge or at the foot of something.
    const std::uint32_t u = (static_cast<std::uint32_t>(name) + lattice.x) & 0xffffu, v = ((static_cast<std::uint32_t>(name) >> 16) + lattice.y) & 0xffffu;
    const FacetName shared_name = (name & ~FacetName{0xffffffffu}) | (v << 16) | u;
    if (const auto known = shared_corners_.find(shared_name); known != shared_corners_.end()) return known->second;
    const FacetCorner corner = facet_corner(world_->scene, facet.middle, facet.level, within, vec2(lattice));
    const auto id = static_cast<std::uint32_t>(corners_.size());
    const FacetName cell = facet_name(facet_cell(corner.point.position, corner.point.normal(), facet.level + static_cast<float>(facet.depth) + group_level));
    const auto [group, fresh] = group_of_cell_.try_emplace(cell, static_cast<std::uint32_t>(groups_.size()));
    if (fresh) {
        unguided_.push_back(static_cast<std::uint32_t>(groups_.size()));
        groups_.emplace_back();
    }
    Group& its_group = groups_[group->second];
    corners_.push_back({.at = {.point = corner.point, .level = facet.level - 1.0f, .guide = its_group.guide.get()}, .group = group->second});
    its_group.corners.push_back(id);
    unfinished_.push_back(id);
    if (corner.shared) shared_corners_.emplace(shared_name, id);
    facet.cut |= corner.cut;
    return id;
}

void FacetCache::work(const Facets& settings, const Deadline& deadline) {
    // Those without links come first, and nothing is refined before light has gone round once.
    std::stable_partition(unfinished_.begin(), unfinished_.end(), [&](std::uint32_t corner) { return corners_[corner].at.by_chance.empty(); });
    // What is missing goes before what is wrong, and that before what is rough.
    link_corners(settings, first_links, 0.35, deadline);
    while (patches_->renewing() && !deadline.passed(0.6)) {
        patches_->renew(patches_at_once);
        light_moves();
    }
    while (!patches_->renewing() && !deadline.passed(0.5) && patches_->mend(patches_at_once)) light_moves();
    do {
        while (!deadline.passed(0.5) && patches_->renew(patches_at_once)) light_moves();
    } while (!deadline.passed(0.5) && patches_->grow(patches_at_once));
    reflect(settings, deadline);
    gather(settings, deadline);
    guide_corners();
    link_corners(settings, most_links, 1.0, deadline);
    if (unfinished_.empty() && !reflecting_ && !patches_->mending() && to_gather_ == 0) look_for_other_lights(deadline);
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
    const auto linked = [&](std::uint32_t corner) { return !corners_[corner].at.by_chance.empty() || corners_[corner].gone; };
    std::vector<std::uint32_t> waiting;
    for (const std::uint32_t number : std::exchange(unguided_, {})) {
        Group& group = groups_[number];
        if (!std::ranges::all_of(group.corners, linked)) {
            waiting.push_back(number);
            continue;
        }
        std::vector<Patches::Job> points;
        for (const std::uint32_t corner : group.corners) points.push_back({.point = &corners_[corner].at, .by_chance = 0, .seed = corner + 1});
        group.guide = std::make_unique<Guide>(patches_->guide_for(points));
        // What was found by chance alone has done its duty.
        for (const std::uint32_t corner : group.corners) link_anew(corner, group.guide.get());
    }
    unguided_.insert(unguided_.end(), waiting.begin(), waiting.end());
}

void FacetCache::link_corners(const Facets& settings, std::uint32_t most, double share, const Deadline& deadline) {
    std::vector<Patches::Job> jobs;
    std::size_t done = 0;
    std::vector<std::uint32_t> again;
    while (done < unfinished_.size() && !deadline.passed(share)) {
        jobs.clear();
        const std::size_t first = done;
        for (; done < unfinished_.size() && jobs.size() < corners_at_once; ++done) {
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
        while (!deadline.passed(0.5) && patches_->renew(patches_at_once)) {}
        light_moves();
        // At once, for what there is: until then a new place is dark.
        tbb::parallel_for(first, done, [&](std::size_t i) { judge(unfinished_[i], settings); });
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
    for (std::size_t rounds = 0; reflecting_ && !patches_->renewing() && !deadline.passed(0.7);) {
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
        tbb::parallel_for(std::size_t{0}, batch, [&](std::size_t i) { judge(static_cast<std::uint32_t>((gathered_ + i) % all), settings); });
        gathered_ = (gathered_ + batch) % all;
        to_gather_ -= batch;
        table_is_old_ = true;
    }
    std::erase_if(unfinished_, [&](std::uint32_t corner) { return corners_[corner].done; });
}

void FacetCache::judge(std::uint32_t corner, const Facets& settings) {
    Corner& it = corners_[corner];
    if (it.at.by_chance.empty()) return;
    const Patches::Gathered gathered = patches_->gather(it.at);
    it.at.irradiance = gathered.irradiance;
    it.lit = true;
    const float mean = luminance(gathered.irradiance);
    const std::size_t links = it.at.by_chance.size();
    // Without a guide it may have missed the brightest thing.
    if (it.at.guide == nullptr) return;
    it.done = it.done || (links >= (mean > 0.0f ? least_links : least_links_in_the_dark) && (gathered.error <= settings.noise * mean || links >= most_links));
}

void FacetCache::split_where_needed() {
    std::vector<FacetName> waiting;
    for (const FacetName name : std::exchange(unsplit_, {})) {
        Facet& facet = facets_.at(name);
        if (facet.split || facet.depth >= most_depth) continue;
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
        if (!facet.cut && high - low <= smooth_contrast * sum) continue;
        facet.split = true;
        table_is_old_ = true;
        const Facet parent = facet;
        const vec2 within(facet_cell(parent.middle.position, parent.middle.normal(), parent.level).within);
        for (std::uint32_t quarter = 0; quarter < 4; ++quarter) {
            const vec2 step = vec2(0.25f) + 0.5f * vec2(quarter & 1, quarter >> 1) - within;
            const vec3 target = along_surface(parent.middle, parent.level, step);
            if (const auto point = surface_near(world_->scene, parent.middle, target, std::exp2(parent.level))) add(*point, parent.level - 1.0f, parent.depth + 1);
        }
        add(parent.middle, parent.level - 1.0f, parent.depth + 1);
    }
    unsplit_.insert(unsplit_.end(), waiting.begin(), waiting.end());
}

void FacetCache::fill_table() {
    std::vector<FacetEntry> entries;
    entries.reserve(facets_.size());
    for (const auto& [name, facet] : facets_) {
        // Where there is no light yet, a coarser one stands in.
        if (std::ranges::any_of(facet.corners, [&](std::uint32_t corner) { return !corners_[corner].lit; })) continue;
        FacetEntry& entry = entries.emplace_back(FacetEntry{.name = name, .irradiance = {}, .split = facet.split});
        for (std::size_t corner = 0; corner < 4; ++corner) entry.irradiance[corner] = corners_[facet.corners[corner]].at.irradiance;
    }
    table_.fill(entries);
}

}  // namespace sl
