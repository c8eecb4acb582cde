// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

struct GLFWwindow;

namespace sl::gl {

/// Where a context comes from; see create_context.
enum class ContextKind { automatic, window, egl, osmesa };

/// "auto", "window", "egl", "osmesa". Throws Error naming the choices.
ContextKind parse_context_kind(std::string_view text);
/// The inverse.
std::string_view context_kind_name(ContextKind kind);

/// An OpenGL 4.5 core context, current on the thread that made it, with the loader filled and KHR_debug on
/// (synchronous). One at a time per process.
class Context {
  public:
    virtual ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;

    ContextKind kind() const { return kind_; }
    const std::string& vendor() const { return vendor_; }
    const std::string& renderer() const { return renderer_; }
    const std::string& version() const { return version_; }

    /// Messages of type error (and undefined behaviour) from the driver since the context was made; tests
    /// require none.
    const std::vector<std::string>& errors() const { return errors_; }
    void clear_errors() { errors_.clear(); }

  protected:
    explicit Context(ContextKind kind);
    using Loader = void (*(*)(const char*))();
    /// Loads functions, checks for 4.5, turns debug output on, and sets what all passes rely on: clip depth 0
    /// to 1, sRGB encoding on write to sRGB formats, seamless cube maps, tightly packed pixels. Throws Error
    /// with one sentence: what was found and what to do.
    void initialise(Loader loader);

  private:
    void watch_debug_output();

    ContextKind kind_;
    std::string vendor_, renderer_, version_;
    std::vector<std::string> errors_;
};

/// egl: without a window; a GPU found by device enumeration first (NVIDIA without a display), then Mesa's
/// surfaceless platform, then software devices. osmesa: software, no GPU stack. automatic: egl, then osmesa.
/// window: needs `window`, made with 4.5 core hints; never chosen by automatic. Throws Error.
std::unique_ptr<Context> create_context(ContextKind kind, GLFWwindow* window = nullptr);

}  // namespace sl::gl
