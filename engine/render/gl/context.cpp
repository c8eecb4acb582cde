// SPDX-License-Identifier: MIT
#include "engine/render/gl/context.h"

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/render/gl/context_makers.h"
#include "engine/render/gl/gl.h"

namespace sl::gl {
namespace {

constexpr std::size_t max_errors = 1000;  // a broken pass repeats itself every frame
bool context_exists = false;

std::string gl_string(GLenum name) {
    const GLubyte* text = glGetString != nullptr ? glGetString(name) : nullptr;
    return text != nullptr ? reinterpret_cast<const char*>(text) : "";
}

/// "4.1 (Core Profile) Mesa 22.3.6" -> "4.1".
std::string_view version_number(std::string_view version) {
    return version.substr(0, version.find_first_not_of("0123456789."));
}

}  // namespace

ContextKind parse_context_kind(std::string_view text) {
    for (ContextKind kind :
         {ContextKind::automatic, ContextKind::window, ContextKind::egl, ContextKind::osmesa}) {
        if (text == context_kind_name(kind)) return kind;
    }
    fail("unknown context \"{}\": choose auto, window, egl or osmesa", text);
}

std::string_view context_kind_name(ContextKind kind) {
    switch (kind) {
        case ContextKind::automatic:
            return "auto";
        case ContextKind::window:
            return "window";
        case ContextKind::egl:
            return "egl";
        case ContextKind::osmesa:
            return "osmesa";
    }
    return "";
}

std::string too_old_message(ContextKind kind, std::string_view renderer, std::string_view version) {
    std::string found = "this driver gives no OpenGL context";
    if (!version.empty()) {
        found = fmt::format("this driver ({}, {}) gives {}", renderer, version, version_number(version));
    }
    const char* advice = kind == ContextKind::osmesa
                             ? "update Mesa (22 or newer), or use --context egl"
                             : "update the driver, or use --context osmesa for software rendering";
    return fmt::format("OpenGL 4.5 core is needed, but {}: {}", found, advice);
}

Context::Context(ContextKind kind) : kind_(kind) {
    CHECK(!context_exists, "one OpenGL context at a time");
    context_exists = true;
}

Context::~Context() {
    context_exists = false;
}

void Context::initialise(Loader loader) {
    const int loaded = gladLoadGL(loader);
    vendor_ = gl_string(GL_VENDOR);
    renderer_ = gl_string(GL_RENDERER);
    version_ = gl_string(GL_VERSION);
    if (loaded < GLAD_MAKE_VERSION(4, 5)) throw Error(too_old_message(kind_, renderer_, version_));
    GLint profile = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    if ((profile & GL_CONTEXT_CORE_PROFILE_BIT) == 0) {
        fail(
            "OpenGL 4.5 core is needed, but this context ({}, {}) is of another profile: ask for the core "
            "profile",
            renderer_, version_);
    }

    watch_debug_output();
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    log::info("OpenGL {} through {}: {}", version_, context_kind_name(kind_), renderer_);
}

void Context::watch_debug_output() {
    // A lambda without captures is a plain function and yet may touch errors_.
    const GLDEBUGPROC on_message = [](GLenum source, GLenum type, GLuint, GLenum severity, GLsizei,
                                      const GLchar* message, const void* user) {
        // Shader messages come back in the compile log, under the names of the files.
        const bool wrong = source != GL_DEBUG_SOURCE_SHADER_COMPILER &&
                           (type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
                            severity == GL_DEBUG_SEVERITY_HIGH);
        if (!wrong) {
            if (type != GL_DEBUG_TYPE_PUSH_GROUP && type != GL_DEBUG_TYPE_POP_GROUP)
                log::debug("OpenGL: {}", message);
            return;
        }
        auto& errors = static_cast<Context*>(const_cast<void*>(user))->errors_;
        if (errors.size() >= max_errors) return;
        if (errors.empty() || errors.back() != message) log::error("OpenGL: {}", message);
        errors.emplace_back(message);
    };
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(on_message, this);
}

std::unique_ptr<Context> create_context(ContextKind kind, GLFWwindow* window) {
    switch (kind) {
        case ContextKind::window:
            return make_window_context(window);
        case ContextKind::egl:
            return make_egl_context();
        case ContextKind::osmesa:
            return make_osmesa_context();
        case ContextKind::automatic:
            break;
    }
    try {
        return make_egl_context();
    } catch (const Error& egl) {
        try {
            auto context = make_osmesa_context();
            log::warn("rendering in software, because EGL gave no context: {}", egl.what());
            return context;
        } catch (const Error& osmesa) {
            fail("no OpenGL context. EGL: {}. OSMesa: {}", egl.what(), osmesa.what());
        }
    }
}

}  // namespace sl::gl
