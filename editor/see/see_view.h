// SPDX-License-Identifier: MIT
#pragma once

#include "editor/see/facet_outlines.h"
#include "editor/see/pixel_probe.h"
#include "editor/see/shown_image.h"
#include "engine/ecs/world.h"

namespace sl {

/// What lies under a picture: any image that the frame makes, the light at one point and where it comes from, and the facets.
class SeeView {
  public:
    ShownImage image;
    PixelProbe probe;
    FacetOutlines facets;
    bool picks = false;  ///< a click into the picture picks a point; while the tab is in front

    /// Before the frame is drawn: what it must keep.
    void prepare(Renderer::Request& request) const;
    /// After it was drawn.
    void update(const SeenFrame& frame);
    /// Over the picture and behind all widgets.
    void draw(World& world, float scale) const;
};

/// The tab "See" of the panel. Inside a window.
void see_tab(const World& world, SeeView& view);

}  // namespace sl
