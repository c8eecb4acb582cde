// SPDX-License-Identifier: MIT
#pragma once

#include "editor/see/light_shares.h"
#include "editor/see/seen_frame.h"
#include "editor/see/texel_shares.h"

namespace sl {

/// What the live picture has at a point.
struct LiveValues {
    vec3 albedo{0.0f};
    vec3 direct{0.0f};      ///< nit, emission included
    vec3 irradiance{0.0f};  ///< indirect, lux
    vec3 radiance{0.0f};    ///< nit
};

/// All that is known of the light at one point.
struct ProbeReading {
    ProbedPoint point;
    Entity entity;                   ///< whose surface it is
    float distance = 0.0f;           ///< from the camera, m
    std::optional<LiveValues> live;  ///< while the camera sees it
    std::vector<LightShare> lights;
    bool shadowed = false;           ///< the lights' shadows were traced
    std::optional<TexelShares> texels;  ///< where the method reads reflective shadow maps
    std::optional<LightMeter::Reading> truth;
};

/// Follows the light at one point of the world, which people pick in the picture.
class PixelProbe {
  public:
    static constexpr std::size_t most_texels = 32;

    /// A place of the picture, in shares of its width and height from the upper left, whose point is to be followed.
    void pick(vec2 place) { picked_ = place; }
    void forget() { *this = {}; }

    /// Before the frame is drawn: what it must keep.
    void prepare(Renderer::Request& request) const;
    /// After it was drawn.
    void update(const SeenFrame& frame);

    /// Nothing while no point was picked.
    const std::optional<ProbeReading>& reading() const { return reading_; }
    /// The last pick met no surface.
    bool missed() const { return missed_; }

  private:
    void take(const SeenFrame& frame, vec2 place);
    void read(const SeenFrame& frame);
    std::optional<LiveValues> live_values(const SeenFrame& frame, const ProbedPoint& point) const;

    std::optional<vec2> picked_;
    std::optional<ProbeReading> reading_;
    bool missed_ = false;
    double until_read_ = 0.0;  ///< s
};

}  // namespace sl
