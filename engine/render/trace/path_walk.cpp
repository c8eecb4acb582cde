// SPDX-License-Identifier: MIT
#include "engine/render/trace/path_walk.h"

#include <algorithm>

#include "engine/render/trace/direct_light.h"
#include "engine/render/trace/directions.h"

namespace sl {

namespace {

using World = TransportWorld;

/// Reflections from which on a path may end by chance, in proportion to what it still carries.
constexpr int certain_reflections = 3;
/// Albedo 1 in a closed room would go on for ever.
constexpr float most_likely_survival = 0.995f;

float largest(vec3 v) { return std::max({v.x, v.y, v.z}); }

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
        if (!point.faces(from)) return vec3(0.0f);
        if (!diffuse) return reflected(point.surface, from, to_eye);
        return diffuse_albedo(point.surface) * (std::max(glm::dot(point.normal(), from), 0.0f) / pi);
    }
};

/// Radiance and irradiance that a vertex gets straight from some source.
struct Arriving {
    vec3 reflected{0.0f};   ///< towards the eye, nit
    vec3 irradiance{0.0f};  ///< lux
};

/// How a scattered ray came to a vertex.
struct Arrival {
    vec3 from;
    float density;  ///< per sr, of its direction
};

/// Light of one directional, spot or point light.
struct Lit {
    vec3 radiance{0.0f};  ///< reflected towards the eye, nit
    std::uint32_t light = 0;
};

class Walk {
  public:
    /// `lit` takes the lit points that scattered rays find, with what they bring to the first surface.
    Walk(const World& world, SampleSequence samples, PathSample& out, std::vector<TracedRay>* recorded, std::vector<LitPoint>* lit)
        : world_(world), samples_(samples), out_(out), recorded_(recorded), lit_(lit) {}

    /// The whole path behind a first surface.
    void from(const SurfacePoint& point, vec3 to_eye) {
        // The cosine lobe gets half at least: the first surface's irradiance is measured whatever it is made of.
        const PathVertex vertex(point, to_eye, false, 0.5f);
        out_.direct = point.emission + point.unlit + lit_by_lights(vertex, nullptr).radiance;
        arrive(vertex);
    }
    /// Only what arrives at a point, whatever it is made of.
    void at(const SurfacePoint& point) { arrive(PathVertex(point, point.normal(), true, 1.0f)); }

  private:
    void arrive(const PathVertex& vertex) {
        out_.surface = true;
        const Arriving glow = lit_by_emitters(vertex);
        out_.direct += glow.reflected;
        out_.irradiance_emission += glow.irradiance;
        out_.irradiance_straight += glow.irradiance;
        if (world_.settings.bounces != 0) {
            const Arriving arriving = lit_by_light_paths(vertex, nullptr);
            out_.irradiance_lights += arriving.irradiance;
            out_.indirect += world_.settings.occlusion ? arriving.reflected : arriving.irradiance * diffuse_albedo(vertex.point.surface) / pi;
        }
        if (!world_.settings.occlusion) return through_everything(vertex);
        const bool only_lights = world_.emitters.empty() && world_.sky == vec3(0.0f);
        if (world_.settings.bounces == 0 && only_lights) return;
        scatter(vertex);
    }

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

    /// A vertex that light is reflected at on its way to another one.
    PathVertex reflecting(const SurfacePoint& point, vec3 to_eye) const {
        const bool diffuse = !world_.settings.occlusion || world_.settings.reflection == Reflection::diffuse;
        return PathVertex(point, to_eye, diffuse, 0.0f);
    }

    /// What each light would contribute unblocked, into `weights_`; the sum of their luminances.
    float weigh_lights(const PathVertex& vertex) {
        weights_.clear();
        float total = 0.0f;
        for (std::size_t i = 0; i < world_.lights.size(); ++i) {
            const bool counts = world_.settings.occlusion || world_.bounces[i] != 0;
            const Incident incident = incident_light(world_.lights[i], vertex.point.position);
            const vec3 light = counts ? vec3(incident.irradiance) * vertex.reflects(vec3(incident.to_light)) : vec3(0.0f);
            weights_.push_back({light, vec3(incident.to_light)});
            total += luminance(light);
        }
        return total;
    }

    /// Light from one of all directional, spot and point lights in place of their sum. After an arrival, the part of it
    /// that is left to scattered rays.
    Lit lit_by_lights(const PathVertex& vertex, const Arrival* arrival) {
        const vec2 xi = samples_.pair();
        const float total = weigh_lights(vertex);
        if (!(total > 0.0f)) return {};
        float left = xi.x * total;
        std::uint32_t chosen = 0;
        for (; chosen + 1 < weights_.size(); ++chosen) {
            left -= luminance(weights_[chosen].light);
            if (left < 0.0f) break;
        }
        const Candidate& candidate = weights_[chosen];
        const float share = luminance(candidate.light) / total;
        if (share <= 0.0f) return {};
        if (world_.casts[chosen] != 0 && occluded(shadow_ray(world_.lights[chosen], vertex.point))) return {};
        float weight = 1.0f / share;
        if (arrival != nullptr && !world_.light_paths.empty()) {
            const vec3 offset = vertex.point.position - arrival->from;
            const float here = arrival->density * share, there = density_of_light_path(chosen, vertex.point, offset);
            weight *= std::isfinite(there) ? here * here / (here * here + there * there) : 0.0f;
        }
        return {candidate.light * weight, chosen};
    }

    /// Density per sr, seen from `offset` before the point, with which rays from a light meet it.
    float density_of_light_path(std::uint32_t light, const SurfacePoint& point, vec3 offset) const {
        const float distance_squared = glm::dot(offset, offset);
        const float cos_surface = std::abs(glm::dot(offset, point.face)) / std::sqrt(distance_squared);
        const float density = world_.light_paths.density(light, point);
        // Seen exactly from the side, the surface has no extent: what is met there is met through rounding alone.
        return density > 0.0f ? density * distance_squared / cos_surface : 0.0f;
    }

    /// Light of one reflection at a point that a ray from a light meets: the part that is not left to scattered rays.
    /// `to_first`: irradiance at the first surface for radiance of this vertex; null where this is the first.
    Arriving lit_by_light_paths(const PathVertex& vertex, const vec3* to_first) {
        if (world_.light_paths.empty()) return {};
        const LightPaths::Drawn drawn = world_.light_paths.sample(samples_.pair());
        const auto hit = intersect(drawn.ray);
        if (!hit || !hit->front) return {};
        const SurfacePoint point = world_.scene.surface_at(*hit);
        const vec3 offset = point.position - vertex.point.position;
        const vec3 direction = glm::normalize(offset);
        const float cos_surface = glm::dot(direction, vertex.point.normal());
        if (!(cos_surface > 0.0f) || !(glm::dot(direction, point.face) < 0.0f)) return {};
        const float total = weigh_lights(reflecting(point, -direction));

        const vec3 light = weights_[drawn.light].light;
        if (!(luminance(light) > 0.0f)) return {};
        const float there = density_of_light_path(drawn.light, point, offset);
        const float here = vertex.lobes.density(direction) * luminance(light) / total;
        const float weight = there / (there * there + here * here);
        if (!(weight > 0.0f)) return {};  // also where `there` is infinite
        if (world_.settings.occlusion) {
            if (!vertex.point.faces(direction)) return {};
            const vec3 origin = vertex.point.origin_towards(direction);
            if (occluded({.origin = origin, .direction = point.origin_towards(-direction) - origin, .farthest = 1.0f})) return {};
        }
        const Arriving result{.reflected = vertex.reflects(direction) * light * weight, .irradiance = light * (cos_surface * weight)};
        found(drawn.light, point, to_first != nullptr ? *to_first * result.reflected : result.irradiance);
        return result;
    }

    Arriving lit_by_emitters(const PathVertex& vertex) {
        if (world_.emitters.empty()) return {};
        const auto path = world_.emitters.path_from(world_.scene, vertex.point, samples_.pair());
        if (!path) return {};
        const float other = vertex.lobes.density(path->direction);
        const float weight = path->density / (path->density * path->density + other * other);  // the power heuristic's weight over density
        if (!(weight > 0.0f) || occluded(path->ray)) return {};
        const float cos_surface = glm::dot(path->direction, vertex.point.normal());
        return {.reflected = vertex.reflects(path->direction) * path->radiance * weight, .irradiance = path->radiance * (cos_surface * weight)};
    }

    /// A scattered ray from the first surface, followed to its end.
    void scatter(const PathVertex& first) {
        vec3 direction = first.lobes.sample(samples_.pair());
        float density = first.lobes.density(direction);
        if (!(density > 0.0f) || !first.point.faces(direction)) return;
        const float to_irradiance = glm::dot(first.point.normal(), direction) / density;
        const vec3 to_eye = first.reflects(direction) / density;
        const auto add = [&](vec3& irradiance, vec3& radiance, vec3 arriving) {
            irradiance += to_irradiance * arriving;
            radiance += to_eye * arriving;
        };
        const auto add_straight = [&](vec3 arriving, int reflections) {
            if (reflections == 0) out_.irradiance_straight += to_irradiance * arriving;
        };
        Ray ray{.origin = first.point.origin_towards(direction), .direction = direction};
        vec3 carried(1.0f);
        for (int reflections = 0;; ++reflections) {
            vec3& radiance = reflections == 0 ? out_.direct : out_.indirect;
            const auto hit = intersect(ray);
            if (!hit) {
                add_straight(world_.sky, reflections);
                return add(out_.irradiance_sky, radiance, carried * world_.sky);
            }
            if (!hit->front) return;  // backs are black
            const SurfacePoint point = world_.scene.surface_at(*hit);
            if (point.emission != vec3(0.0f)) {
                const float other = world_.emitters.path_density(*hit, point, ray.direction);
                const vec3 glow = carried * point.emission * (density * density / (density * density + other * other));
                add_straight(glow, reflections);
                add(out_.irradiance_emission, radiance, glow);
            }
            const int bounces = world_.settings.bounces;
            if (bounces != TransportSettings::until_converged && reflections >= bounces) return;

            const PathVertex vertex = reflecting(point, -ray.direction);
            const Arrival arrival{ray.origin, density};
            const Lit lit = lit_by_lights(vertex, &arrival);
            add(out_.irradiance_lights, out_.indirect, carried * lit.radiance);
            const vec3 to_first = carried * to_irradiance;
            found(lit.light, point, to_first * lit.radiance);
            add(out_.irradiance_emission, out_.indirect, carried * lit_by_emitters(vertex).reflected);
            const bool another = bounces == TransportSettings::until_converged || reflections + 1 < bounces;
            if (another) add(out_.irradiance_lights, out_.indirect, carried * lit_by_light_paths(vertex, &to_first).reflected);

            direction = vertex.lobes.sample(samples_.pair());
            density = vertex.lobes.density(direction);
            if (!(density > 0.0f)) return;
            carried *= vertex.reflects(direction) / density;
            const float strongest = largest(carried);
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
                const Arrival arrival{first.point.position, density};
                const Lit lit = lit_by_lights(reflecting(point, -direction), &arrival);
                const vec3 light = lit.radiance * (cos_surface / density);
                found(lit.light, point, light);
                out_.irradiance_lights += light;
                out_.indirect += light * albedo / pi;
            }
            ray.origin = point.origin_towards(direction);
        }
    }

    void found(std::uint32_t light, const SurfacePoint& point, vec3 at_first) {
        // What nothing stands in the way of is not met first by the light's rays.
        if (lit_ == nullptr || at_first == vec3(0.0f) || world_.casts[light] == 0) return;
        lit_->push_back({light, point.position, largest(at_first)});
    }

    struct Candidate {
        vec3 light, to_light;
    };
    const World& world_;
    SampleSequence samples_;
    PathSample& out_;
    std::vector<TracedRay>* recorded_;
    std::vector<LitPoint>* lit_;
    static thread_local std::vector<Candidate> weights_;
};

thread_local std::vector<Walk::Candidate> Walk::weights_;

}  // namespace

void walk_path(const TransportWorld& world, const SurfacePoint& point, vec3 to_eye, SampleSequence samples, PathSample& out, const PathRecord& record) {
    Walk(world, samples, out, record.rays, record.lit).from(point, to_eye);
}

void gather_path(const TransportWorld& world, const SurfacePoint& point, SampleSequence samples, PathSample& out, const PathRecord& record) {
    Walk(world, samples, out, record.rays, record.lit).at(point);
}

}  // namespace sl
