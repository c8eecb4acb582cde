// SPDX-License-Identifier: MIT
#include "engine/core/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <span>

#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/core/window_gamepad.h"
#include "engine/core/window_keys.h"

namespace sl {

namespace {

constexpr double wait_while_unseen = 0.25;  // s

std::string last_glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text != nullptr ? text : "no reason given";
}

void hint_context(int major, int minor) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
    const bool core = major * 10 + minor >= 32;
    glfwWindowHint(GLFW_OPENGL_PROFILE, core ? GLFW_OPENGL_CORE_PROFILE : GLFW_OPENGL_ANY_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, core ? GLFW_TRUE : GLFW_FALSE);
}

/// What the display gives when 4.5 is refused; only for the message.
std::string version_found() {
    hint_context(1, 0);
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow* probe = glfwCreateWindow(16, 16, "", nullptr, nullptr);
    if (probe == nullptr) return "no OpenGL at all";
    const std::string version =
        fmt::format("OpenGL {}.{}", glfwGetWindowAttrib(probe, GLFW_CONTEXT_VERSION_MAJOR),
                    glfwGetWindowAttrib(probe, GLFW_CONTEXT_VERSION_MINOR));
    glfwDestroyWindow(probe);
    return version;
}

GLFWmonitor* monitor_of(GLFWwindow* window) {
    ivec2 place(0), size(0);
    glfwGetWindowPos(window, &place.x, &place.y);
    glfwGetWindowSize(window, &size.x, &size.y);
    int count = 0;
    GLFWmonitor** monitors = glfwGetMonitors(&count);
    GLFWmonitor* best = glfwGetPrimaryMonitor();
    std::int64_t best_area = 0;
    for (int i = 0; i < count; ++i) {
        ivec2 corner(0);
        glfwGetMonitorPos(monitors[i], &corner.x, &corner.y);
        const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
        if (mode == nullptr) continue;
        const ivec2 shared =
            glm::min(place + size, corner + ivec2(mode->width, mode->height)) - glm::max(place, corner);
        const std::int64_t area = std::int64_t{std::max(shared.x, 0)} * std::max(shared.y, 0);
        if (area > best_area) {
            best_area = area;
            best = monitors[i];
        }
    }
    return best;
}

}  // namespace

struct Window::Callbacks {
    static Window& of(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

    static void key(GLFWwindow* window, int glfw_key, int, int action, int) {
        const std::optional<Key> key = key_of(glfw_key);
        if (!key || action == GLFW_REPEAT) return;
        Input& events = of(window).events_;
        events.keys_down.set(static_cast<std::size_t>(*key), action == GLFW_PRESS);
        if (action == GLFW_PRESS) events.keys_pressed.set(static_cast<std::size_t>(*key));
    }
    static void button(GLFWwindow* window, int glfw_button, int action, int) {
        if (glfw_button < 0 || glfw_button >= static_cast<int>(mouse_button_count)) return;
        const auto index = static_cast<std::size_t>(glfw_button);  // left, right, middle in GLFW too
        Input& events = of(window).events_;
        events.buttons_down.set(index, action == GLFW_PRESS);
        if (action == GLFW_PRESS) events.buttons_pressed.set(index);
    }
    static void pointer(GLFWwindow* window, double x, double y) {
        Window& self = of(window);
        const glm::dvec2 now(x, y);
        if (self.events_.mouse_captured) self.events_.mouse_delta += vec2(now - self.pointer_);
        self.pointer_ = now;
    }
    static void scroll(GLFWwindow* window, double, double y) {
        of(window).events_.scroll += static_cast<float>(y);
    }
    static void drop(GLFWwindow* window, int count, const char** paths) {
        for (const char* path : std::span(paths, static_cast<std::size_t>(count))) of(window).events_.dropped.emplace_back(path);
    }
    static void focus(GLFWwindow* window, int focused) {
        if (focused == GLFW_FALSE) of(window).release_all();
    }
};

Window::Window(const WindowSettings& settings) : vsync_(settings.vsync) {
    if (glfwInit() == GLFW_FALSE) {
        fail(
            "there is no display for a window ({}): render without one with `./play tour`, or log in to a "
            "desktop",
            last_glfw_error());
    }
    glfwDefaultWindowHints();
    hint_context(4, 5);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // the frame is drawn elsewhere and copied here
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    window_ = glfwCreateWindow(static_cast<int>(settings.size.x), static_cast<int>(settings.size.y),
                               settings.title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) {
        const std::string reason = last_glfw_error();
        const std::string found = version_found();
        glfwTerminate();
        fail(
            "OpenGL 4.5 core is needed, but this display gives {} ({}): update the graphics driver, or "
            "render without a "
            "window: `./play tour --context egl`, or --context osmesa for software",
            found, reason);
    }
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, &Callbacks::key);
    glfwSetMouseButtonCallback(window_, &Callbacks::button);
    glfwSetCursorPosCallback(window_, &Callbacks::pointer);
    glfwSetScrollCallback(window_, &Callbacks::scroll);
    glfwSetDropCallback(window_, &Callbacks::drop);
    glfwSetWindowFocusCallback(window_, &Callbacks::focus);
    glfwMakeContextCurrent(window_);
    set_vsync(vsync_);
    if (settings.fullscreen) toggle_fullscreen();
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

Input Window::poll() {
    if (drawable()) {
        glfwPollEvents();
    } else {
        glfwWaitEventsTimeout(wait_while_unseen);
    }
    poll_gamepad();
    Input frame = events_;
    events_.next_frame();
    return frame;
}

void Window::poll_gamepad() {
    const bool focused = glfwGetWindowAttrib(window_, GLFW_FOCUSED) != GLFW_FALSE;
    const std::optional<GamepadReading> reading = focused ? read_gamepad() : std::nullopt;
    events_.gamepad = reading ? gamepad_after(events_.gamepad, *reading) : Gamepad{};
}

void Window::swap() {
    glfwSwapBuffers(window_);
}

void Window::set_vsync(bool on) {
    vsync_ = on;
    glfwSwapInterval(on ? 1 : 0);
}

bool Window::close_requested() const {
    return glfwWindowShouldClose(window_) != GLFW_FALSE;
}
void Window::request_close() {
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::stay_open() {
    glfwSetWindowShouldClose(window_, GLFW_FALSE);
}

uvec2 Window::framebuffer_size() const {
    ivec2 size(0);
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return uvec2(glm::max(size, ivec2(0)));
}

bool Window::drawable() const {
    const uvec2 size = framebuffer_size();
    return size.x > 0 && size.y > 0 && glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_FALSE &&
           glfwGetWindowAttrib(window_, GLFW_VISIBLE) != GLFW_FALSE;
}

float Window::content_scale() const {
    vec2 scale(1.0f);
    glfwGetWindowContentScale(window_, &scale.x, &scale.y);
    return std::clamp(std::max(scale.x, scale.y), 0.5f, 8.0f);
}

void Window::capture_mouse(bool captured) {
    if (captured == events_.mouse_captured) return;
    glfwSetInputMode(window_, GLFW_CURSOR, captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    // Where the pointer jumps now is no movement.
    glfwGetCursorPos(window_, &pointer_.x, &pointer_.y);
    events_.mouse_captured = captured;
}

bool Window::fullscreen() const {
    return glfwGetWindowMonitor(window_) != nullptr;
}

void Window::toggle_fullscreen() {
    if (fullscreen()) {
        glfwSetWindowMonitor(window_, nullptr, windowed_place_.x, windowed_place_.y, windowed_size_.x,
                             windowed_size_.y, GLFW_DONT_CARE);
    } else {
        GLFWmonitor* monitor = monitor_of(window_);
        const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
        if (mode == nullptr) {
            log::warn("no monitor to fill: the window stays as it is");
            return;
        }
        glfwGetWindowPos(window_, &windowed_place_.x, &windowed_place_.y);
        glfwGetWindowSize(window_, &windowed_size_.x, &windowed_size_.y);
        glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }
    set_vsync(vsync_);  // some systems forget it
}

void Window::release_all() {
    capture_mouse(false);
    events_.ignore_keys();
    events_.ignore_mouse();
}

}  // namespace sl
