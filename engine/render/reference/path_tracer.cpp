// SPDX-License-Identifier: MIT
#include "engine/render/reference/path_tracer.h"

#include <algorithm>

#include "engine/core/check.h"
#include "engine/render/passes/frame_input.h"
#include "engine/render/reference/directions.h"

namespace sl {

namespace {

using World = PathTracer::World;

/// Reflections from which on a path may end by chance, in proportion to what it still carries.
constexpr int certain_reflections = 3;
/// Albedo 1 in a closed room would go on for ever.
constexpr float most_likely_survival = 0.995f;

float luminance(vec3 colour) { return glm::dot(colour, vec3(0.2126f, 0.7152f, 0.0722f)); }

/// A surface point as a path's vertex: its reflectance in the chosen model, seen from where the path came.
struct PathVertex {
    SurfacePoint point;
    vec3 to_eye;
    bool diffuse;
    DirectionSampler lobes;

    PathVertex(const SurfacePoint& point_, vec3 to_eye_, bool diffuse_, float least_diffuse)
        : point(point_), to_eye(to_eye_), diffuse(diffuse_), lobes(point_.surface, to_eye_, diffuse_, least_diffuse) {}

    /// f_r · cos θ.
    vec3 reflects(vec3 from) const {
        if (!diffuse) return reflected(point.surface, from, to_eye);
        return diffuse_albedo(point.surface) * (std::max(glm::dot(point.normal(), from), 0.0f) / pi);
    }
};

/// Radiance and irradiance that a vertex gets straight from some source.
struct Arriving {
    vec3 reflected{0.0f};   ///< towards the eye, nit
    vec3 irradiance{0.0f};  ///< lux
};

class Walk {
  public:
    Walk(const World& world, SampleSequence samples, PathSample& out, std::vector<TracedRay>* recorded)
        : world_(world), samples_(samples), out_(out), recorded_(recorded) {}

    /// The whole path behind a first surface.
    void from(const SurfacePoint& point, vec3 to_eye) {
        // The cosine lobe gets half at least: the first surface's irradiance is measured whatever it is made of.
        const PathVertex vertex(point, to_eye, false, 0.5f);
        out_.surface = true;
        out_.direct = point.emission + lit_by_lights(vertex, false);
        const Arriving glow = lit_by_emitters(vertex);
        out_.direct += glow.reflected;
        out_.irradiance_emission += glow.irradiance;
        if (!world_.settings.occlusion) return through_everything(vertex);
        const bool only_lights = world_.emitters.empty() && world_.sky == vec3(0.0f);
        if (world_.settings.bounces == 0 && only_lights) return;
        scatter(vertex);
    }

  private:
    std::optional<TriangleHit> intersect(const Ray& ray) {
        ++out_.rays;
        if (recorded_ != nullptr) recorded_->push_back({ray, false});
        return world_.scene.intersect(ray);
    }
    bool occluded(const Ray& ray) {
        ++out_.rays;
        if (recorded_ != nullptr) recorded_->push_back({ray, true});
        return world_.scene.occluded(ray);
    }

    /// Radiance reflected towards the eye of light from all directional, spot and point lights.
    vec3 lit_by_lights(const PathVertex& vertex, bool bouncing_only) {
        const vec2 xi = samples_.pair();
        weights_.clear();
        float total = 0.0f;
        for (std::size_t i = 0; i < world_.lights.size(); ++i) {
            const bool counts = !bouncing_only || world_.bounces[i] != 0;
            const Incident incident = incident_light(world_.lights[i], vertex.point.position);
            const vec3 light = counts ? vec3(incident.irradiance) * vertex.reflects(vec3(incident.to_light)) : vec3(0.0f);
            weights_.push_back({light, vec3(incident.to_light), incident.to_light.w});
            total += luminance(light);
        }
        if (!(total > 0.0f)) return vec3(0.0f);
        float left = xi.x * total;
        std::size_t chosen = 0;
        for (; chosen + 1 < weights_.size(); ++chosen) {
            left -= luminance(weights_[chosen].light);
            if (left < 0.0f) break;
        }
        const Candidate& candidate = weights_[chosen];
        const float share = luminance(candidate.light);
        if (share <= 0.0f) return vec3(0.0f);
        if (world_.casts[chosen] != 0) {
            const bool endless = world_.lights[chosen].kind.x == light_directional;
            const vec3 origin = vertex.point.origin_towards(candidate.to_light);
            // To the light itself, not along the direction that the surface had: in a corner the two differ.
            const vec3 direction = endless ? candidate.to_light : vec3(world_.lights[chosen].position) - origin;
            if (occluded({.origin = origin, .direction = direction, .farthest = endless ? std::numeric_limits<float>::infinity() : 1.0f})) return vec3(0.0f);
        }
        return candidate.light * (total / share);
    }

    Arriving lit_by_emitters(const PathVertex& vertex) {
        if (world_.emitters.empty()) return {};
        const EmitterSample drawn = world_.emitters.sample(samples_.pair());
        const SurfacePoint emitter = world_.scene.surface_at(drawn.hit);
        const vec3 origin = vertex.point.origin_towards(drawn.position - vertex.point.position);
        const vec3 offset = emitter.position - origin;
        const float distance_squared = glm::dot(offset, offset);
        if (distance_squared <= 0.0f) return {};
        const vec3 direction = offset / std::sqrt(distance_squared);
        const float cos_emitter = -glm::dot(direction, emitter.face);
        const float cos_surface = glm::dot(direction, vertex.point.normal());
        if (cos_emitter <= 0.0f || cos_surface <= 0.0f) return {};
        const float density = drawn.density * distance_squared / cos_emitter;
        const float other = vertex.lobes.density(direction);
        const float weight = density / (density * density + other * other);  // the power heuristic's weight over density
        const vec3 target = emitter.origin_towards(-direction);
        if (!(weight > 0.0f) || occluded({.origin = origin, .direction = target - origin, .farthest = 1.0f})) return {};
        return {.reflected = vertex.reflects(direction) * emitter.emission * weight, .irradiance = emitter.emission * (cos_surface * weight)};
    }

    /// A scattered ray from the first surface, followed to its end.
    void scatter(const PathVertex& first) {
        vec3 direction = first.lobes.sample(samples_.pair());
        float density = first.lobes.density(direction);
        if (!(density > 0.0f)) return;
        const float to_irradiance = glm::dot(first.point.normal(), direction) / density;
        const vec3 to_eye = first.reflects(direction) / density;
        const auto add = [&](vec3& irradiance, vec3& radiance, vec3 arriving) {
            irradiance += to_irradiance * arriving;
            radiance += to_eye * arriving;
        };
        Ray ray{.origin = first.point.origin_towards(direction), .direction = direction};
        vec3 carried(1.0f);
        for (int reflections = 0;; ++reflections) {
            vec3& radiance = reflections == 0 ? out_.direct : out_.indirect;
            const auto hit = intersect(ray);
            if (!hit) return add(out_.irradiance_sky, radiance, carried * world_.sky);
            if (!hit->front) return;  // backs are black
            const SurfacePoint point = world_.scene.surface_at(*hit);
            if (point.emission != vec3(0.0f)) {
                const float cos_emitter = -glm::dot(ray.direction, point.face);
                const float other = cos_emitter > 0.0f ? world_.emitters.density(*hit) * hit->distance * hit->distance / cos_emitter : 0.0f;
                add(out_.irradiance_emission, radiance, carried * point.emission * (density * density / (density * density + other * other)));
            }
            const int bounces = world_.settings.bounces;
            if (bounces != TransportSettings::until_converged && reflections >= bounces) return;

            const PathVertex vertex(point, -ray.direction, world_.settings.reflection == Reflection::diffuse, 0.0f);
            add(out_.irradiance_lights, out_.indirect, carried * lit_by_lights(vertex, false));
            add(out_.irradiance_emission, out_.indirect, carried * lit_by_emitters(vertex).reflected);

            direction = vertex.lobes.sample(samples_.pair());
            density = vertex.lobes.density(direction);
            if (!(density > 0.0f)) return;
            carried *= vertex.reflects(direction) / density;
            const float strongest = std::max({carried.x, carried.y, carried.z});
            if (!(strongest > 0.0f)) return;
            if (reflections >= certain_reflections) {
                const float survival = std::min(strongest, most_likely_survival);
                if (samples_.pair().x >= survival) return;
                carried /= survival;
            }
            ray = {.origin = point.origin_towards(direction), .direction = direction};
        }
    }

    /// One diffuse bounce of the lights that bounce, from every surface along a ray, whatever stands between.
    void through_everything(const PathVertex& first) {
        const vec3 direction = first.lobes.sample(samples_.pair());
        const float density = first.lobes.density(direction);
        if (!(density > 0.0f)) return;
        const float cos_surface = glm::dot(first.point.normal(), direction);
        const vec3 albedo = diffuse_albedo(first.point.surface);
        Ray ray{.origin = first.point.origin_towards(direction), .direction = direction};
        while (const auto hit = intersect(ray)) {
            const SurfacePoint point = world_.scene.surface_at(*hit);
            if (hit->front) {
                const vec3 light = lit_by_lights(PathVertex(point, -direction, true, 1.0f), true) * (cos_surface / density);
                out_.irradiance_lights += light;
                out_.indirect += light * albedo / pi;
            }
            ray.origin = point.origin_towards(direction);
        }
    }

    struct Candidate {
        vec3 light, to_light;
        float distance;
    };
    const World& world_;
    SampleSequence samples_;
    PathSample& out_;
    std::vector<TracedRay>* recorded_;
    static thread_local std::vector<Candidate> weights_;
};

thread_local std::vector<Walk::Candidate> Walk::weights_;

FrameParams camera_params(const RenderScene& scene, uvec2 size) {
    CHECK(scene.view, "a reference needs a camera");
    return frame_params(scene, size.x, size.y, 0);
}

}  // namespace

PathTracer::PathTracer(const RenderScene& scene, uvec2 size, const TransportSettings& settings)
    : world_{.scene = TraceScene(scene), .emitters = Emitters(world_.scene), .lights = build_light_table(scene).params,
             .casts = {}, .bounces = {}, .sky = scene.sky_radiance, .settings = settings},
      frame_(camera_params(scene, size)) {
    for (const RenderScene::Light& light : scene.lights) {
        // Point lights have no shadow setting: nothing shines through walls.
        world_.casts.push_back(light.casts_shadow || light.kind == RenderScene::Light::Kind::point);
        world_.bounces.push_back(light.bounces);
    }
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

PathSample PathTracer::sample(uvec2 pixel, std::uint32_t number) const { return trace(pixel, number, nullptr); }

PathSample PathTracer::sample_recorded(uvec2 pixel, std::uint32_t number, std::vector<TracedRay>& rays) const {
    return trace(pixel, number, &rays);
}

PathSample PathTracer::trace(uvec2 pixel, std::uint32_t number, std::vector<TracedRay>* recorded) const {
    PathSample out;
    SampleSequence samples(world_.settings.seed * 2u + (number & 1u), pixel, number >> 1);
    const vec2 within = samples.pair();
    const Ray ray = camera_ray(pixel, world_.settings.pixel_area ? within : vec2(0.5f));
    ++out.rays;
    if (recorded != nullptr) recorded->push_back({ray, false});
    const auto hit = world_.scene.intersect_front(ray);
    if (!hit) {
        out.direct = world_.sky;
        return out;
    }
    Walk(world_, samples, out, recorded).from(world_.scene.surface_at(*hit), -glm::normalize(ray.direction));
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
