// SPDX-License-Identifier: MIT
#include "engine/render/facets/patches.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>

#include "engine/render/facets/merged_boxes.h"
#include "engine/render/trace/direct_light.h"
#include "engine/render/trace/directions.h"

namespace sl {

namespace {

/// Changes that some links may not know of.
constexpr std::size_t most_unfollowed = 64, few_unfollowed = 16;
/// Patches that are gone, of which nothing is worth a look.
constexpr std::size_t few_gone = 4096;
/// What packing may turn a direction by, rad.
constexpr float packed_angle = 0.004f;

/// Whether light reaches a box at all.
bool may_throw_shadow(const LightParams& light, const Bounds& box) {
    const bool ends = light.kind.x != light_directional && light.position.w > 0.0f;
    return !ends || box.grown(light.position.w).contains(vec3(light.position));
}

constexpr float half_diagonal = 1.7320508f;  // of a cube, over its half side

/// Where, seen along a directional light, boxes stand before what lies behind them.
struct Shade {
    vec3 right, up;
    vec2 low{std::numeric_limits<float>::infinity()}, high{-std::numeric_limits<float>::infinity()};

    Shade(vec3 direction, std::span<const Bounds> boxes) {
        const mat3 basis = basis_around(direction);
        right = basis[0];
        up = basis[1];
        for (const Bounds& box : boxes) {
            const vec2 middle = across(box.centre());
            const vec3 half = 0.5f * (box.high - box.low);
            const vec2 extent(glm::dot(glm::abs(right), half), glm::dot(glm::abs(up), half));
            low = glm::min(low, middle - extent);
            high = glm::max(high, middle + extent);
        }
    }
    vec2 across(vec3 point) const { return {glm::dot(right, point), glm::dot(up, point)}; }
    /// Of some point in the cube of that half side round `point`.
    bool reaches(vec3 point, float half_side) const {
        const vec2 place = across(point);
        const float within = half_diagonal * half_side;
        return glm::all(glm::greaterThanEqual(place, low - within)) && glm::all(glm::lessThanEqual(place, high + within));
    }
};

}  // namespace

void Patches::move(vec3 offset) {
    measure_world();
    move_names(first_, offset);
    for (Bounds& box : changes_) box = box.moved(offset);
    tbb::parallel_for(std::size_t{0}, patches_.size(), [&](std::size_t id) {
        Patch& patch = patches_[id];
        if (patch.gone) return;
        patch.cell = facet_name_moved(patch.cell, offset);
        patch.middle.point.position += offset;
        marks_[id].position += offset;
        patch.bright_place += offset;
        for (Sample& sample : patch.samples) sample.position += offset;
        places_[id] += vec4(offset, 0.0f);
    });
}

int Patches::coarsest_cell() const {
    int level = 0;
    for (const auto& [name, id] : first_) level = std::max(level, facet_level_of(name));
    return level;
}

void Patches::change(std::span<const Bounds> boxes) {
    measure_world();
    forget(boxes);
    changes_.insert(changes_.end(), boxes.begin(), boxes.end());
    all_changes_ += static_cast<std::uint32_t>(boxes.size());
    mended_ = 0;
    // Where changes come faster than they are followed, few large ones stand for all: who has not followed the last of
    // them looks at each.
    if (changes_.size() <= most_unfollowed) return;
    changes_ = merged_boxes(std::move(changes_), few_unfollowed);
    all_changes_ += static_cast<std::uint32_t>(changes_.size());
}

void Patches::forget_changes() {
    changes_.clear();
    free_.insert(free_.end(), gone_.begin(), gone_.end());
    gone_.clear();
    linked_.clear();
}

bool Patches::mend(std::size_t most) {
    if (!mending()) return false;
    std::vector<Job> jobs;
    for (; mended_ < patches_.size() && jobs.size() < most; ++mended_) {
        const auto id = static_cast<std::uint32_t>(mended_);
        if (!patches_[id].middle.by_chance.empty()) jobs.push_back({.point = &patches_[id].middle, .by_chance = links_of_a_patch, .seed = id + 1, .patch = id});
    }
    mend(jobs);
    return true;
}

void Patches::mend(std::span<const Job> jobs) {
    std::vector<std::vector<Probe>> passing(jobs.size());
    tbb::parallel_for(std::size_t{0}, jobs.size(), [&](std::size_t i) {
        const Job& job = jobs[i];
        GatherPoint& point = *job.point;
        const std::size_t unknown = std::min<std::size_t>(all_changes_ - point.changes, changes_.size());
        point.changes = all_changes_;
        std::vector<Bounds> boxes(changes_.end() - static_cast<std::ptrdiff_t>(unknown), changes_.end());
        // Rays of a patch start all over it.
        const float start = job.patch == nothing ? 0.0f : patches_[job.patch].side;
        for (Bounds& box : boxes) box = box.grown(start + packed_angle * glm::length(box.centre() - point.point.position));
        const auto look_at = [&](const std::vector<Link>& links, bool guided) {
            for (std::uint32_t k = 0; k < links.size(); ++k) {
                if (std::ranges::any_of(boxes, [&](const Bounds& box) { return passes(point, links[k], box); })) passing[i].push_back({&job, guided, k, {}});
            }
        };
        look_at(point.by_chance, false);
        look_at(point.guided, true);
        point.renewed += static_cast<std::uint32_t>(passing[i].size());
    });
    std::vector<Probe> rays;
    for (auto& some : passing) rays.insert(rays.end(), some.begin(), some.end());
    trace(rays);
}

bool Patches::passes(const GatherPoint& point, const Link& link, const Bounds& box) const {
    if (link.patch < nothing && patches_[link.patch].gone) return true;
    // A guided ray that went below the surface has met nothing anywhere.
    return link.direction != 0 && box.meets(point.point.position, unpack_normal(link.direction), link.distance);
}

void Patches::forget(std::span<const Bounds> boxes) {
    std::vector<std::uint32_t> lights;
    for (std::uint32_t i = 0; i < world_.lights.size(); ++i) {
        if (std::ranges::any_of(boxes, [&](const Bounds& box) { return may_throw_shadow(world_.lights[i], box); })) lights.push_back(i);
    }
    std::vector<Shade> shades;
    for (const std::uint32_t light : lights) {
        if (world_.lights[light].kind.x == light_directional) shades.emplace_back(vec3(world_.lights[light].direction), boxes);
    }
    Bounds all;
    for (const Bounds& box : boxes) all.add(box);
    // Of most patches a look at all boxes together tells that none matters.
    const auto any_may_matter = [&](vec3 middle, float side, float light_there) {
        return all.grown(reach * side).contains(middle) || shades.size() < lights.size() ||
               std::ranges::any_of(shades, [&](const Shade& shade) { return shade.reaches(middle, reach * side); }) ||
               std::ranges::any_of(glowing_, [&](const Emitters::Ball& ball) { return brings(ball, middle, side) > too_little * light_there; });
    };
    const auto may_matter = [&](const Bounds& box, vec3 middle, float side, float light_there) {
        const Bounds wide = box.grown(reach * side);
        if (wide.contains(middle)) return true;
        for (const std::uint32_t number : lights) {
            const LightParams& light = world_.lights[number];
            const bool directional = light.kind.x == light_directional;
            if (wide.meets(middle, directional ? -vec3(light.direction) : vec3(light.position) - middle, directional ? std::numeric_limits<float>::infinity() : 1.0f)) return true;
        }
        return std::ranges::any_of(glowing_, [&](const Emitters::Ball& ball) {
            return brings(ball, middle, side) > too_little * light_there && wide.grown(ball.radius).meets(middle, ball.place - middle, 1.0f);
        });
    };
    enum class Fate : char { stays, waits, goes };
    std::vector<Fate> fates(patches_.size(), Fate::stays);
    tbb::parallel_for(std::size_t{0}, patches_.size(), [&](std::size_t id) {
        const vec3 middle(places_[id]);
        const float side = places_[id].w, light_there = luminance(reflected_[id]);
        if (side < 0.0f || !any_may_matter(middle, side, light_there)) return;
        for (const Bounds& box : boxes) {
            if (!may_matter(box, middle, side, light_there)) continue;
            Patch& patch = patches_[id];
            if (box.contains(patch.middle.point.position)) {
                fates[id] = Fate::goes;
                return;
            }
            if (box.grown(reach * side).contains(middle)) {
                patch.samples.clear();
                fates[id] = Fate::waits;
            } else if (forget_shadows(patch, middle, box, lights)) {
                fates[id] = Fate::waits;
            }
        }
    });
    for (std::uint32_t id = 0; id < patches_.size(); ++id) {
        if (fates[id] == Fate::waits) wait(id);
        if (fates[id] != Fate::goes) continue;
        remove(id);
        gone_.push_back(id);
        // Whether anything is linked to it was not asked since.
        if (id < linked_.size()) linked_[id] = 1;
    }
    remove_from_lists();
}

void Patches::remove(std::uint32_t id) {
    remove_from_cell(id);
    patches_[id] = Patch{.gone = true};
    places_[id].w = -1.0f;
    set_radiosity(id);
}

void Patches::remove_from_lists() {
    for (std::vector<std::uint32_t>* list : {&dark_, &waiting_, &rough_, &ungrown_}) std::erase_if(*list, [&](std::uint32_t id) { return patches_[id].gone; });
}

void Patches::forget_all_but_seen_from(std::span<const GatherPoint* const> points) {
    linked_.assign(patches_.size(), 0);
    std::vector<std::uint32_t> found;
    const auto follow_links = [&](const GatherPoint& point) {
        for (const std::vector<Link>* links : {&point.by_chance, &point.guided}) {
            for (const Link& link : *links) {
                if (link.patch < nothing && std::exchange(linked_[link.patch], 1) == 0) found.push_back(link.patch);
            }
        }
    };
    for (const GatherPoint* point : points) follow_links(*point);
    for (std::size_t i = 0; i < found.size(); ++i) follow_links(patches_[found[i]].middle);
    for (std::uint32_t id = 0; id < patches_.size(); ++id) {
        if (linked_[id] != 0 || patches_[id].gone) continue;
        remove(id);
        free_.push_back(id);
    }
    bury_unlinked();
    remove_from_lists();
}

bool Patches::many_gone() const { return gone_.size() > std::max(few_gone, patches_.size() / 4); }

void Patches::begin_burying() {
    linked_.assign(patches_.size(), 0);
    looked_at_ = 0;
}

void Patches::keep_linked(const GatherPoint& point) {
    for (const std::vector<Link>* links : {&point.by_chance, &point.guided}) {
        for (const Link& link : *links) {
            // Others may say the same at the same time.
            if (link.patch < linked_.size()) std::atomic_ref(linked_[link.patch]).store(1, std::memory_order_relaxed);
        }
    }
}

bool Patches::bury(std::size_t most) {
    const std::size_t last = std::min(looked_at_ + most, patches_.size());
    tbb::parallel_for(looked_at_, last, [&](std::size_t i) { keep_linked(patches_[i].middle); });
    looked_at_ = last;
    if (last < patches_.size()) return true;
    bury_unlinked();
    return false;
}

void Patches::bury_unlinked() {
    const auto unlinked = std::ranges::partition(gone_, [&](std::uint32_t id) { return id >= linked_.size() || linked_[id] != 0; });
    free_.insert(free_.end(), unlinked.begin(), unlinked.end());
    gone_.erase(unlinked.begin(), unlinked.end());
    linked_.clear();
}

bool Patches::forget_shadows(Patch& patch, vec3 middle, const Bounds& box, std::span<const std::uint32_t> lights) const {
    bool any = false;
    for (const std::uint32_t number : lights) {
        const LightParams& light = world_.lights[number];
        const bool directional = light.kind.x == light_directional;
        const vec3 to_light = directional ? -vec3(light.direction) : vec3(light.position) - middle;
        const bool far = !directional && light.position.w > 0.0f && glm::length(to_light) > light.position.w + patch.side;
        if (far || !box.grown(reach * patch.side).meets(middle, to_light, directional ? std::numeric_limits<float>::infinity() : 1.0f)) continue;
        any |= narrow(number, patch);
        for (Sample& sample : patch.samples) {
            const Ray ray = shadow_ray(light, sample.place());
            if (!patch.knows(sample) || !box.meets(ray.origin, ray.direction, ray.farthest)) continue;
            sample.lit_in = 0;
            any = true;
        }
    }
    for (const Emitters::Ball& ball : glowing_) {
        if (brings(ball, middle, patch.side) <= too_little * luminance(patch.lit) || !box.grown(ball.radius + reach * patch.side).meets(middle, ball.place - middle, 1.0f)) continue;
        patch.forget_light();
        any = true;
    }
    return any;
}

}  // namespace sl
