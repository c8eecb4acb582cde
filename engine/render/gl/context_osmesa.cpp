// SPDX-License-Identifier: MIT
// No glad here: osmesa.h brings Mesa's own gl.h.
#include <GL/osmesa.h>

#include <array>

#include "engine/core/error.h"
#include "engine/render/gl/context_makers.h"

namespace sl::gl {
namespace {

class OsmesaContext final : public Context {
  public:
    OsmesaContext() : Context(ContextKind::osmesa) {}
    ~OsmesaContext() override {
        if (context_ == nullptr) return;
        OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
        OSMesaDestroyContext(context_);
    }

    void open() {
        context_ = create(4, 5);
        // An older context is made only to say in the message what the driver has.
        if (context_ == nullptr) context_ = create(3, 2);
        if (context_ == nullptr ||
            OSMesaMakeCurrent(context_, pixels_.data(), GL_UNSIGNED_BYTE, side, side) == GL_FALSE) {
            throw Error(too_old_message(ContextKind::osmesa, "", ""));
        }
        initialise(OSMesaGetProcAddress);
    }

  private:
    static constexpr int side = 16;
    static constexpr std::size_t bytes = std::size_t{side} * side * 4;

    static OSMesaContext create(int major, int minor) {
        const std::array attributes = {OSMESA_FORMAT,
                                       OSMESA_RGBA,
                                       OSMESA_PROFILE,
                                       OSMESA_CORE_PROFILE,
                                       OSMESA_CONTEXT_MAJOR_VERSION,
                                       major,
                                       OSMESA_CONTEXT_MINOR_VERSION,
                                       minor,
                                       0};
        return OSMesaCreateContextAttribs(attributes.data(), nullptr);
    }

    OSMesaContext context_ = nullptr;
    std::array<unsigned char, bytes> pixels_{};  // OSMesa wants a default framebuffer; nobody draws to it
};

}  // namespace

std::unique_ptr<Context> make_osmesa_context() {
    auto context = std::make_unique<OsmesaContext>();
    context->open();
    return context;
}

}  // namespace sl::gl
