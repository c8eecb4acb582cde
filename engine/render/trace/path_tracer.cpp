// SPDX-License-Identifier: MIT
#include "engine/render/trace/path_tracer.h"

#include <cmath>

#include "engine/core/check.h"
#include "engine/render/scene/frame_params.h"
#include "engine/render/trace/learn_light_paths.h"

namespace sl {

namespace {

constexpr std::uint32_t most_pilot_pixels = 6000;

FrameParams camera_params(const RenderScene& scene, uvec2 size) {
    CHECK(scene.view, "a reference needs a camera");
    return frame_params(scene, size.x, size.y, 0);
}

}  // namespace

PathTracer::PathTracer(const RenderScene& scene, uvec2 size, const TransportSettings& settings)
    : world_(scene, settings), frame_(camera_params(scene, size)) {
    if (!settings.light_paths || settings.bounces == 0) return;
    // From the whole picture alone, so that all parts of one that are traced apart draw from the same density.
    const auto step = static_cast<std::uint32_t>(std::ceil(std::sqrt(double(size.x) * size.y / most_pilot_pixels)));
    const uvec2 count = (size + step - 1u) / step;
    learn_light_paths(world_, std::size_t{count.x} * count.y, [&](std::size_t place, std::uint32_t number, std::vector<LitPoint>& lit) {
        trace(uvec2(place % count.x * step, place / count.x * step), number, {.lit = &lit});
    });
}

std::uint64_t PathTracer::content_hash() const {
    std::uint64_t hash = hash_bytes(world_.scene.content_hash(), &frame_, sizeof frame_);
    hash = hash_bytes(hash, world_.lights.data(), world_.lights.size() * sizeof(LightParams));
    hash = hash_bytes(hash, world_.casts.data(), world_.casts.size());
    return hash_bytes(hash, world_.bounces.data(), world_.bounces.size());
}

Ray PathTracer::camera_ray(uvec2 pixel, vec2 within) const {
    const vec2 size(frame_.ray_right.w, frame_.ray_up.w);
    const vec2 at = (vec2(pixel) + within) / size;
    return {.origin = vec3(frame_.camera_position), .direction = view_ray(frame_, vec2(2.0f * at.x - 1.0f, 1.0f - 2.0f * at.y)), .nearest = frame_.camera_position.w};
}

PathSample PathTracer::sample(uvec2 pixel, std::uint32_t number) const { return trace(pixel, number, {}); }

PathSample PathTracer::sample_recorded(uvec2 pixel, std::uint32_t number, std::vector<TracedRay>& rays) const {
    return trace(pixel, number, {.rays = &rays});
}

PathSample PathTracer::trace(uvec2 pixel, std::uint32_t number, const PathRecord& record) const {
    PathSample out;
    SampleSequence samples(world_.settings.seed * 2u + (number & 1u), pixel, number >> 1);
    const vec2 within = samples.pair();
    const Ray ray = camera_ray(pixel, world_.settings.pixel_area ? within : vec2(0.5f));
    ++out.rays;
    if (record.rays != nullptr) record.rays->push_back({ray, false});
    const auto hit = world_.scene.intersect_front(ray);
    if (!hit) {
        out.direct = world_.sky;
        return out;
    }
    const SurfacePoint seen = world_.scene.surface_at(*hit);
    walk_path(world_, seen, -glm::normalize(ray.direction), samples, out, record);
    const float left = air_transmittance(frame_, glm::length(seen.position - ray.origin));
    out.direct = glm::mix(world_.sky, out.direct, left);
    out.indirect *= left;
    return out;
}

FirstSurface PathTracer::first_surface(uvec2 pixel) const {
    const auto hit = world_.scene.intersect_front(camera_ray(pixel, vec2(0.5f)));
    if (!hit) return {};
    const SurfacePoint point = world_.scene.surface_at(*hit);
    const float distance = glm::dot(point.position - vec3(frame_.camera_position), vec3(frame_.ray_forward));
    return {.albedo = vec3(point.surface.base_colour), .normal = point.normal(), .position = point.position, .depth = frame_.camera_position.w / distance};
}

}  // namespace sl
