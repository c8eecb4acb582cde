// SPDX-License-Identifier: MIT
#pragma once

#include "editor/projection.h"
#include "editor/see/seen_frame.h"

namespace sl {

/// The facets near the camera as lines over the picture, while the method `facets` runs.
class FacetOutlines {
  public:
    enum class Colour { irradiance, noise };
    bool on = false;
    Colour colour = Colour::irradiance;

    /// Before the frame is drawn: what it must keep.
    void prepare(Renderer::Request& request) const;
    /// After it was drawn.
    void update(const SeenFrame& frame);
    void draw(const Projection& project, float scale) const;

    /// How many are drawn.
    std::size_t size() const { return outlines_.size(); }
    /// What the brightest colour stands for: lux, or a share of the irradiance.
    float top() const { return top_; }

  private:
    struct Outline {
        std::array<dvec3, 4> corners;  ///< round it, in the world
        float value;                   ///< in units of the top
    };
    void read(const SeenFrame& frame);

    std::vector<Outline> outlines_;
    Colour shown_ = Colour::irradiance;
    float top_ = 0.0f;
    double until_read_ = 0.0;  ///< s
};

}  // namespace sl
