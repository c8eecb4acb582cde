// SPDX-License-Identifier: MIT
#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <optional>

#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/render/gl/context_makers.h"

namespace sl::gl {
namespace {

bool has_word(const char* words, std::string_view word) {
    if (words == nullptr) return false;
    const std::string padded = fmt::format(" {} ", words);
    return padded.find(fmt::format(" {} ", word)) != std::string::npos;
}

template <class Function>
Function egl_function(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

/// A display to try, best first.
struct Candidate {
    EGLenum platform;
    void* native;
    std::string name;
    bool gpu;
};

/// GPUs before the surfaceless platform before software devices: with NVIDIA's driver beside Mesa, the
/// surfaceless platform is Mesa's software renderer, and the GPU is reached as a device only.
std::vector<Candidate> list_candidates() {
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    std::vector<Candidate> gpus, others;
    if (has_word(client, "EGL_MESA_platform_surfaceless")) {
        others.push_back({EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, "surfaceless", false});
    }
    const auto query_devices = egl_function<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    const auto query_string = egl_function<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    if (has_word(client, "EGL_EXT_platform_device") && query_devices != nullptr && query_string != nullptr) {
        std::array<EGLDeviceEXT, 32> devices{};
        EGLint count = 0;
        if (query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_FALSE)
            count = 0;
        for (EGLint i = 0; i < count; ++i) {
            EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
            const bool software = has_word(query_string(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
            auto& list = software ? others : gpus;
            list.push_back({EGL_PLATFORM_DEVICE_EXT, device, fmt::format("device {}", i), !software});
        }
    }
    gpus.insert(gpus.end(), others.begin(), others.end());
    return gpus;
}

class EglContext final : public Context {
  public:
    EglContext() : Context(ContextKind::egl) {}
    ~EglContext() override {
        if (display_ == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT) eglDestroyContext(display_, context_);
        eglTerminate(display_);
        eglReleaseThread();
    }

    void open(const Candidate& candidate) {
        const auto get_display = egl_function<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
        EGLDisplay display = get_display != nullptr
                                 ? get_display(candidate.platform, candidate.native, nullptr)
                                 : EGL_NO_DISPLAY;
        if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) {
            fail("EGL cannot open its {} display", candidate.name);
        }
        display_ = display;
        const char* extensions = eglQueryString(display_, EGL_EXTENSIONS);
        if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE || !has_word(extensions, "EGL_KHR_create_context") ||
            !has_word(extensions, "EGL_KHR_surfaceless_context")) {
            fail("EGL's {} display makes no OpenGL context without a surface", candidate.name);
        }
        const EGLConfig config = choose_config(extensions);
        context_ = create(config, 4, 5);
        // An older context is made only to say in the message what the driver has.
        if (context_ == EGL_NO_CONTEXT) context_ = create(config, 3, 2);
        if (context_ == EGL_NO_CONTEXT ||
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
            throw Error(too_old_message(ContextKind::egl, "", ""));
        }
        initialise(eglGetProcAddress);
    }

  private:
    EGLConfig choose_config(const char* extensions) const {
        if (has_word(extensions, "EGL_KHR_no_config_context")) return EGL_NO_CONFIG_KHR;
        const std::array attributes = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
        EGLConfig config = EGL_NO_CONFIG_KHR;
        EGLint count = 0;
        eglChooseConfig(display_, attributes.data(), &config, 1, &count);
        return count > 0 ? config : EGL_NO_CONFIG_KHR;
    }

    EGLContext create(EGLConfig config, EGLint major, EGLint minor) const {
        const std::array attributes = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                                       major,
                                       EGL_CONTEXT_MINOR_VERSION_KHR,
                                       minor,
                                       EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                                       EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                                       EGL_CONTEXT_FLAGS_KHR,
                                       EGL_CONTEXT_OPENGL_DEBUG_BIT_KHR,
                                       EGL_NONE};
        return eglCreateContext(display_, config, EGL_NO_CONTEXT, attributes.data());
    }

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> make_egl_context() {
    std::optional<Error> failure;
    for (const Candidate& candidate : list_candidates()) {
        auto context = std::make_unique<EglContext>();
        try {
            context->open(candidate);
            return context;
        } catch (const Error& error) {
            const auto level = candidate.gpu ? spdlog::level::warn : spdlog::level::debug;
            spdlog::log(level, "EGL {}: {}", candidate.name, error.what());
            failure = error;
        }
    }
    if (failure) throw Error(*failure);
    fail(
        "EGL offers no display without a window: install libegl1 and libgl1-mesa-dri, or use --context "
        "osmesa");
}

}  // namespace sl::gl
