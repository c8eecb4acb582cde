// SPDX-License-Identifier: MIT
#include "engine/render/facets/patches.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "engine/render/trace/direct_light.h"

namespace sl {

namespace {

/// What packing may turn a direction by, rad.
constexpr float packed_angle = 0.004f;

/// Whether light reaches a box at all.
bool may_throw_shadow(const LightParams& light, const Bounds& box) {
    const bool ends = light.kind.x != light_directional && light.position.w > 0.0f;
    return !ends || box.grown(light.position.w).contains(vec3(light.position));
}

}  // namespace

void Patches::change(const TransportWorld& world, const Bounds& box) {
    use(world);
    forget(box);
    changes_.push_back(box);
    ++all_changes_;
    mended_ = 0;
}

void Patches::forget_changes() {
    changes_.clear();
    free_.insert(free_.end(), gone_.begin(), gone_.end());
    gone_.clear();
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

void Patches::forget(const Bounds& box) {
    std::vector<LightParams> lights;
    std::ranges::copy_if(world_->lights, std::back_inserter(lights), [&](const LightParams& light) { return may_throw_shadow(light, box); });
    const auto may_matter = [&](vec3 middle, float side) {
        const Bounds wide = box.grown(1.6f * side);
        if (wide.contains(middle)) return true;
        for (const LightParams& light : lights) {
            const bool directional = light.kind.x == light_directional;
            if (wide.meets(middle, directional ? -vec3(light.direction) : vec3(light.position) - middle, directional ? std::numeric_limits<float>::infinity() : 1.0f)) return true;
        }
        return std::ranges::any_of(glowing_, [&](const Emitters::Ball& ball) { return wide.grown(ball.radius).meets(middle, ball.place - middle, 1.0f); });
    };
    enum class Fate : char { stays, waits, goes };
    std::vector<Fate> fates(patches_.size(), Fate::stays);
    tbb::parallel_for(std::size_t{0}, patches_.size(), [&](std::size_t id) {
        const vec3 middle(places_[id]);
        const float side = places_[id].w;
        if (side < 0.0f || !may_matter(middle, side)) return;
        Patch& patch = patches_[id];
        if (box.contains(middle)) {
            fates[id] = Fate::goes;
        } else if (box.grown(1.5f * side).contains(middle)) {
            patch.samples.clear();
            fates[id] = Fate::waits;
        } else if (forget_shadows(patch, box, lights)) {
            fates[id] = Fate::waits;
        }
    });
    for (std::uint32_t id = 0; id < patches_.size(); ++id) {
        if (fates[id] == Fate::waits) wait(id);
        if (fates[id] != Fate::goes) continue;
        remove_from_cell(id);
        patches_[id] = Patch{.gone = true};
        places_[id].w = -1.0f;
        set_radiosity(id);
        gone_.push_back(id);
    }
    const auto gone = [&](std::uint32_t id) { return patches_[id].gone; };
    std::erase_if(dark_, gone);
    std::erase_if(waiting_, gone);
    std::erase_if(rough_, gone);
    std::erase_if(ungrown_, gone);
}

bool Patches::forget_shadows(Patch& patch, const Bounds& box, std::span<const LightParams> lights) const {
    bool any = false;
    const SurfacePoint& middle = patch.middle.point;
    for (const LightParams& light : lights) {
        const Ray to_light = shadow_ray(light, middle);
        const bool far = light.position.w > 0.0f && to_light.farthest <= 1.0f && glm::length(to_light.direction) > light.position.w + patch.side;
        if (far || !box.grown(1.5f * patch.side).meets(to_light.origin, to_light.direction, to_light.farthest)) continue;
        for (Sample& sample : patch.samples) {
            const Ray ray = shadow_ray(light, sample.place());
            if (!sample.known || !box.meets(ray.origin, ray.direction, ray.farthest)) continue;
            sample.known = false;
            any = true;
        }
    }
    for (const Emitters::Ball& ball : glowing_) {
        if (!box.grown(ball.radius + 1.5f * patch.side).meets(middle.position, ball.place - middle.position, 1.0f)) continue;
        for (Sample& sample : patch.samples) sample.known = false;
        any = true;
    }
    return any;
}

}  // namespace sl
