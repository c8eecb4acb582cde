// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/reference/emitters.h"
#include "engine/render/reference/light_paths.h"
#include "engine/render/reference/samples.h"
#include "shared/frame.h"
#include "shared/lights.h"

namespace sl {

/// How surfaces other than the first reflect.
enum class Reflection {
    full,    ///< with their specular lobes
    diffuse  ///< as Lambertian surfaces, which is what a reflective shadow map takes them for
};

/// What transport a reference holds.
struct TransportSettings {
    static constexpr int until_converged = -1;
    int bounces = until_converged;  ///< reflections before the first surface; 0: nothing but direct light
    /// false: indirect light passes through everything, which is the model of a reflective shadow map. One bounce of
    /// the lights that bounce, diffuse.
    bool occlusion = true;
    Reflection reflection = Reflection::full;
    bool pixel_area = true;  ///< false: all samples of a pixel pass through its centre, as a rasterizer's do
    bool light_paths = true; ///< also look for lit points from the lights' side: less noise, the same mean
    std::uint32_t seed = 1;

    bool operator==(const TransportSettings&) const = default;
};

/// What one path brings. Radiance in nit, irradiance in lux.
struct PathSample {
    vec3 direct{0.0f};               ///< radiance: emitted, or lit without a reflection in between; the sky
    vec3 indirect{0.0f};             ///< radiance: lit by reflections
    vec3 irradiance_lights{0.0f};    ///< at the first surface, by reflected light of directional, spot and point lights
    vec3 irradiance_sky{0.0f};       ///< by the sky, straight or reflected
    vec3 irradiance_emission{0.0f};  ///< by glowing surfaces, straight or reflected
    bool surface = false;            ///< there is a first surface
    std::uint32_t rays = 0;          ///< traced for it

    /// All that arrives at the first surface but what comes straight from directional, spot and point lights: what a GI
    /// method is asked for.
    vec3 irradiance() const { return irradiance_lights + irradiance_sky + irradiance_emission; }
};

/// A ray as a path asked for it.
struct TracedRay {
    Ray ray;
    bool shadow = false;  ///< only whether it is blocked was asked
};

/// The first surface behind a pixel's centre.
struct FirstSurface {
    vec3 albedo{0.0f}, normal{0.0f}, position{0.0f};
    float depth = 0.0f;  ///< reversed like the rasterizer's: near / distance along the view axis; 0 is the background
};

/// Path tracing with next-event estimation (Kajiya 1986; Veach 1997): at each vertex one shadow ray to a punctual light
/// drawn by what it would contribute unblocked, and one to a glowing triangle, combined with hitting it by the power
/// heuristic; a uniform sky is met by scattered rays alone, whose density already is its cosine. Points that punctual
/// lights shine on are found twice, by scattered rays and by rays from the lights (LightPaths), combined in the same way.
/// Unbiased but for rounding. All queries may run on any number of threads.
class PathTracer {
  public:
    /// The scene's view must be there; width and height in pixels. Throws Error when the ray tracer does not start.
    PathTracer(const RenderScene& scene, uvec2 size, const TransportSettings& settings);

    /// Pixel (0, 0) is the upper left. Samples with even and odd numbers are two independent sequences.
    PathSample sample(uvec2 pixel, std::uint32_t number) const;
    /// The same, and the rays that it traced (but for those past backs on the way from the camera), for measuring what
    /// their intersections alone cost.
    PathSample sample_recorded(uvec2 pixel, std::uint32_t number, std::vector<TracedRay>& rays) const;
    FirstSurface first_surface(uvec2 pixel) const;

    const TraceScene& scene() const { return world_.scene; }
    /// Of the scene, its lights and the view: two tracers with one hash and the same settings trace the same picture.
    std::uint64_t content_hash() const;

    /// What paths walk in.
    struct World {
        TraceScene scene;
        Emitters emitters;
        std::vector<LightParams> lights;
        std::vector<char> casts;    ///< per light: things stand in its way
        std::vector<char> bounces;  ///< per light: it has a reflective shadow map
        vec3 sky;                   ///< nit
        TransportSettings settings;
        LightPaths light_paths{};  ///< empty while they are looked for
    };

  private:
    Ray camera_ray(uvec2 pixel, vec2 within) const;
    PathSample trace(uvec2 pixel, std::uint32_t number, std::vector<TracedRay>* recorded, std::vector<LitPoint>* lit) const;
    std::vector<LitPoint> find_lit_points(std::uint32_t run) const;

    World world_;
    FrameParams frame_;
};

}  // namespace sl
