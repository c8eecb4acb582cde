// SPDX-License-Identifier: MIT
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "engine/core/check.h"
#include "engine/render/gl/context_makers.h"
#include "engine/render/gl/gl.h"

namespace sl::gl {
namespace {

class WindowContext final : public Context {
  public:
    WindowContext() : Context(ContextKind::window) {}
    ~WindowContext() override {
        // The window owns the GL context and may outlive this object, to which the callback points.
        if (opened_) glDebugMessageCallback(nullptr, nullptr);
    }
    void open(GLFWwindow* window) {
        glfwMakeContextCurrent(window);
        initialise(glfwGetProcAddress);
        opened_ = true;
    }

  private:
    bool opened_ = false;
};

}  // namespace

std::unique_ptr<Context> make_window_context(GLFWwindow* window) {
    CHECK(window != nullptr, "a window context needs a window");
    auto context = std::make_unique<WindowContext>();
    context->open(window);
    return context;
}

}  // namespace sl::gl
