// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "editor/key_taps.h"
#include "engine/core/window.h"

namespace sl {

/// Dear ImGui over a window with a current OpenGL context: made once, then begin … draw in each frame. Writes
/// no settings file.
class ImguiLayer {
  public:
    explicit ImguiLayer(const Window& window);
    ~ImguiLayer();
    ImguiLayer(const ImguiLayer&) = delete;
    ImguiLayer& operator=(const ImguiLayer&) = delete;

    /// Widgets may be drawn from here on. Takes from `input` what belongs to a widget, so that the game does
    /// not see it.
    void begin(Input& input);
    /// Draws the frame's widgets to the bound framebuffer; colours go there as they are.
    void draw();
    /// For a frame that is not drawn.
    void skip();

    /// Whether somebody is typing into a widget.
    static bool has_keyboard();
    /// Size of widgets in units of their usual size.
    float scale() const { return scale_; }

  private:
    float scale_ = 1.0f;
    std::optional<KeyTaps> taps_;
};

}  // namespace sl
