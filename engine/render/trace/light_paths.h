// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/trace/square_density.h"
#include "engine/render/trace/trace_scene.h"
#include "shared/lights.h"

namespace sl {

/// A point that a light shines on, and how much its reflection brings to a picture.
struct LitPoint {
    std::uint32_t light = 0;
    vec3 position;
    float weight = 0.0f;
};

/// Rays out of directional, spot and point lights, towards where a pilot run found points whose reflected light a picture
/// needs: a patch of sun on a floor is found from the sun's side at once, and hardly ever by rays scattered in the room.
/// (Emission guided by importance: Vorba et al. 2014, "On-line Learning of Parametric Mixture Models for Light Transport
/// Simulation", with a quadtree for the mixture.)
class LightPaths {
  public:
    LightPaths() = default;
    /// `bounds` of everything that may stand in the way.
    LightPaths(std::span<const LightParams> lights, const Bounds& bounds, std::span<const LitPoint> found);

    /// Rays all over what each of some lights shines on, which is where a search begins.
    static LightPaths everywhere(std::span<const LightParams> lights, const Bounds& bounds, const std::vector<char>& which);

    /// No ray can be drawn: nothing lit was found.
    bool empty() const { return sources_.empty(); }

    /// A ray that leaves a light.
    struct Drawn {
        std::uint32_t light = 0;
        Ray ray;
    };
    /// xi in [0, 1)²; not when empty.
    Drawn sample(vec2 xi) const;
    /// Density, per m² of surface, with which `sample` picks this light and meets this point, if nothing stands between.
    float density(std::uint32_t light, const SurfacePoint& point) const;

  private:
    /// Coordinates of a light's rays: metres across parallel light; for a cone 1 - cos of the angle to its axis, and the
    /// angle round it, both of which are uniform over solid angle.
    struct Source {
        std::uint32_t light;
        bool parallel;
        vec3 position;            ///< of a spot or point light; of a directional one: on a plane before everything
        mat3 basis;               ///< the last axis is that of the light
        vec2 low{0.0f}, size{1.0f};  ///< the part of the coordinates that the density's square covers
        float before = 0.0f, share = 0.0f;  ///< shares of the sources before it, and its own
        SquareDensity rays{{}};

        vec2 coordinates(vec3 point) const;
        Ray ray(vec2 coordinates) const;
    };
    static Source source_of(std::uint32_t light, const LightParams& params, const Bounds& bounds);

    std::vector<Source> sources_;
};

}  // namespace sl
