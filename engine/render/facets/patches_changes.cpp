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

bool Patches::mend(std::size_t most) {
    if (!mending()) return false;
    std::vector<Job> jobs;
    for (; mended_ < grown_ && jobs.size() < most; ++mended_) {
        const auto id = static_cast<std::uint32_t>(mended_);
        if (!patches_[id].gone) jobs.push_back({.point = &patches_[id].middle, .by_chance = links_of_a_patch, .seed = id + 1, .patch = id});
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
    tbb::parallel_for(std::size_t{0}, patches_.size(), [&](std::size_t id) {
        Patch& patch = patches_[id];
        const vec3 middle = patch.middle.point.position;
        if (box.contains(middle)) {
            patch.gone = true;
        } else if (box.grown(1.5f * patch.side).contains(middle)) {
            patch.samples.clear();
        } else {
            forget_shadows(patch, box, lights);
        }
    });
    for (std::uint32_t id = 0; id < patches_.size(); ++id) {
        Patch& patch = patches_[id];
        const auto unlit = [](const Sample& sample) { return !sample.known; };
        if (patch.gone) {
            patch.albedo = patch.lit = patch.glow = patch.middle.irradiance = vec3(0.0f);
            set_radiosity(id);
            remove_from_cell(id);
        } else if (patch.samples.empty() || std::ranges::any_of(patch.samples, unlit)) {
            wait(id);
        }
    }
    const auto gone = [&](std::uint32_t id) { return patches_[id].gone; };
    std::erase_if(waiting_, gone);
    std::erase_if(rough_, gone);
}

void Patches::forget_shadows(Patch& patch, const Bounds& box, std::span<const LightParams> lights) const {
    const SurfacePoint& middle = patch.middle.point;
    for (const LightParams& light : lights) {
        const Ray to_light = shadow_ray(light, middle);
        const bool far = light.position.w > 0.0f && to_light.farthest <= 1.0f && glm::length(to_light.direction) > light.position.w + patch.side;
        if (far || !box.grown(1.5f * patch.side).meets(to_light.origin, to_light.direction, to_light.farthest)) continue;
        for (Sample& sample : patch.samples) {
            const Ray ray = shadow_ray(light, sample.place());
            sample.known = sample.known && !box.meets(ray.origin, ray.direction, ray.farthest);
        }
    }
    for (const Emitters::Ball& ball : glowing_) {
        if (!box.grown(ball.radius + 1.5f * patch.side).meets(middle.position, ball.place - middle.position, 1.0f)) continue;
        for (Sample& sample : patch.samples) sample.known = false;
    }
}

}  // namespace sl
