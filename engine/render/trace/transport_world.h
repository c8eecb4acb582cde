// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/trace/emitters.h"
#include "engine/render/trace/light_paths.h"
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
    Relief relief = Relief::tilted;

    bool operator==(const TransportSettings&) const = default;
};

/// What light moves in: everything that paths ask of a scene.
struct TransportWorld {
    TraceScene scene;
    Emitters emitters;
    std::vector<LightParams> lights;
    std::vector<char> casts;    ///< per light: things stand in its way
    std::vector<char> bounces;  ///< per light: it has a reflective shadow map
    vec3 sky;                   ///< nit
    TransportSettings settings;
    LightPaths light_paths{};   ///< empty while they are looked for

    /// Throws Error when the ray tracer does not start.
    TransportWorld(const RenderScene& scene, const TransportSettings& settings);

    /// Takes surfaces and what glows from the scene anew, at the cost of what differs; lights and sky stay as they are.
    void resurface(const RenderScene& scene);

    /// Changes all positions by `offset`, m: the scene's origin is another one.
    void move(vec3 offset);

    /// Takes lights and sky from the scene anew; its surfaces must be the same.
    void relight(const RenderScene& scene);
};

}  // namespace sl
