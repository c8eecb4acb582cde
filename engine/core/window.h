// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/core/input.h"

struct GLFWwindow;

namespace sl {

/// What a window begins with.
struct WindowSettings {
    std::string title = "Secondlight";
    uvec2 size{1280, 720};  ///< screen units
    bool fullscreen = false;
    bool vsync = true;
};

/// A window for an OpenGL 4.5 core context; gl::create_context makes that current and loads it. One at a
/// time.
class Window {
  public:
    /// Throws Error naming what was found where there is no display or no OpenGL 4.5.
    explicit Window(const WindowSettings& settings);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* native() const { return window_; }

    /// Handles what has happened and tells it as input. While there is nothing to draw to it waits for the
    /// next event, a quarter of a second at most. Without focus no key is held, the mouse is free and the gamepad
    /// is not heard.
    Input poll();
    /// Needs a current context.
    void swap();
    /// Whether swap waits for the screen. Needs a current context.
    void set_vsync(bool on);

    /// Somebody asked the window to close; it goes when the Window does.
    bool close_requested() const;
    void request_close();
    /// Takes that back, whoever asked for it.
    void stay_open();
    /// Pixels; 0 x 0 while minimised on some systems.
    uvec2 framebuffer_size() const;
    /// Whether a frame would be seen: not minimised, not hidden, not empty.
    bool drawable() const;
    /// Pixels per unit in which people want texts and widgets drawn.
    float content_scale() const;

    bool mouse_captured() const { return events_.mouse_captured; }
    /// Captured: hidden, bound to the window, and moving without end.
    void capture_mouse(bool captured);
    /// Fullscreen on the monitor that shows most of the window, and back to where it was.
    void toggle_fullscreen();
    bool fullscreen() const;

  private:
    struct Callbacks;
    void release_all();
    void poll_gamepad();

    GLFWwindow* window_ = nullptr;
    Input events_;  ///< gathered by callbacks until the next poll
    glm::dvec2 pointer_{0.0};
    bool vsync_ = true;
    ivec2 windowed_place_{0}, windowed_size_{0};
};

}  // namespace sl
