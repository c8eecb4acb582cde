// SPDX-License-Identifier: MIT
#include "game/app/headless.h"

#include "engine/core/error.h"

namespace sl {

namespace {

std::unique_ptr<gl::Context> headless_context(const GlobalFlags& flags) {
    const gl::ContextKind kind = gl::parse_context_kind(flags.context);
    if (kind == gl::ContextKind::window) fail("this command works without a window; use --context auto, egl or osmesa");
    return gl::create_context(kind);
}

}  // namespace

Headless::Headless(const GlobalFlags& flags) : context(headless_context(flags)), renderer(shader_folder()) {}

void Headless::check_errors() const {
    if (!context->errors().empty()) {
        fail("OpenGL reported {} errors, the first: {}", context->errors().size(), context->errors().front());
    }
}

}  // namespace sl
