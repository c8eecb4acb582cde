// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/trace/samples.h"
#include "engine/render/trace/transport_world.h"

namespace sl {

/// What one path brings. Radiance in nit, irradiance in lux.
struct PathSample {
    vec3 direct{0.0f};               ///< radiance: emitted, or lit without a reflection in between; the sky
    vec3 indirect{0.0f};             ///< radiance: lit by reflections
    vec3 irradiance_lights{0.0f};    ///< at the first surface, by reflected light of directional, spot and point lights
    vec3 irradiance_sky{0.0f};       ///< by the sky, straight or reflected
    vec3 irradiance_emission{0.0f};  ///< by glowing surfaces, straight or reflected
    vec3 irradiance_straight{0.0f};  ///< of the last two, what comes without a reflection
    bool surface = false;            ///< there is a first surface
    std::uint32_t rays = 0;          ///< traced for it

    /// All that arrives at the first surface but what comes straight from directional, spot and point lights: what a GI
    /// method is asked for.
    vec3 irradiance() const { return irradiance_lights + irradiance_sky + irradiance_emission; }
    /// Of that, what has been reflected at least once.
    vec3 bounced_irradiance() const { return irradiance() - irradiance_straight; }
};

/// A ray as a path asked for it.
struct TracedRay {
    Ray ray;
    bool shadow = false;  ///< only whether it is blocked was asked
};

/// What a path leaves behind besides its light; null where it is not wanted.
struct PathRecord {
    std::vector<TracedRay>* rays = nullptr;
    std::vector<LitPoint>* lit = nullptr;  ///< the lit points that it found, with what they bring to the first surface
};

/// Follows one path from a first surface to its end, and adds what it brings to `out`.
void walk_path(const TransportWorld& world, const SurfacePoint& point, vec3 to_eye, SampleSequence samples, PathSample& out, const PathRecord& record = {});
/// The same for the irradiance at a point alone, in the hemisphere of its normal: no direct light, no reflection to an eye.
void gather_path(const TransportWorld& world, const SurfacePoint& point, SampleSequence samples, PathSample& out, const PathRecord& record = {});

}  // namespace sl
