// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>

#include "engine/ecs/app.h"
#include "engine/ecs/systems/load_models.h"
#include "engine/render/renderer.h"
#include "game/settings/key_bindings.h"

namespace sl {

/// Frame times as people can read them: a mean over the last half second or so.
class FrameMeter {
  public:
    void add(double seconds) {
        const double share = std::min(1.0, seconds / 0.5);
        mean_ = mean_ == 0.0 ? seconds : mean_ + share * (seconds - mean_);
    }
    double milliseconds() const { return mean_ * 1e3; }

  private:
    double mean_ = 0.0;
};

/// What is drawn over the picture.
struct HudInput {
    const Renderer::Result& frame;
    double frame_ms = 0.0;
    double gi_ms = 0.0;
    const KeyBindings& keys;
    bool help = false;
    bool panel = false;  ///< is open
    bool mouse_captured = false;
    bool click_measures = false;  ///< and does not capture the mouse
    std::span<const std::string> shader_errors;
    std::string failure;  ///< why there is no picture; empty when there is one
    std::vector<ModelBeingRead> being_read;
    bool placeholder = false;  ///< the scene only stands for one that is being read
};

/// Text at the top left, crosshair, notice, and, when asked, the list of keys; behind all widgets.
void draw_hud(App& app, const HudInput& input);

}  // namespace sl
