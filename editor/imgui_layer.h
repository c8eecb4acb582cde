// SPDX-License-Identifier: MIT
#pragma once

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
    /// not see it. `navigate`: keyboard and gamepad move among widgets.
    void begin(Input& input, bool navigate = false);
    /// Draws the frame's widgets to the bound framebuffer; colours go there as they are.
    void draw();
    /// For a frame that is not drawn.
    void skip();

    /// Whether somebody is typing into a widget.
    static bool has_keyboard();
    /// Whether somebody is holding or moving a widget, or typing into it.
    static bool has_active_widget();
    /// Size of widgets in units of their usual size; larger on screens of very many pixels.
    float scale() const;

  private:
    float scale_ = 1.0f;
};

}  // namespace sl
