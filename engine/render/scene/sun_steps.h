// SPDX-License-Identifier: MIT
#pragma once

#include "engine/render/scene/light_map.h"

namespace sl {

/// Where a scene is so large that a sun's map lies in tiles, drawing them all takes the time of many frames. So a sun that moves
/// a little, as it does in the course of a day, is held where it is until the map of where it goes is drawn, some tiles a frame.
class SunSteps {
  public:
    /// The scene with its suns where their maps are; it is valid as long as `scene` and this are, and until the next call.
    /// `at_once`: nothing is held. So it is with suns that move far.
    const RenderScene& hold(const RenderScene& scene, bool at_once);
    /// Adds the maps that are to be drawn beside those in use.
    void add_next_layers(LightTable& table) const;
    /// Those are all drawn: the suns move on in the next frame.
    void next_is_drawn() { next_is_drawn_ = true; }

  private:
    std::vector<vec3> shown_;  ///< directions of all directional lights
    RenderScene held_, next_;
    bool moving_ = false;      ///< `next_` is where the suns go
    bool next_is_drawn_ = false;
    std::uint32_t array_ = 0;  ///< LightTable::sun_array
};

}  // namespace sl
