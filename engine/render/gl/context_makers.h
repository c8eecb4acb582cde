// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "engine/render/gl/context.h"

namespace sl::gl {

/// One function per kind of context, each in its own file with its own platform header. All throw Error.
std::unique_ptr<Context> make_egl_context();
/// Software, without a GPU stack.
std::unique_ptr<Context> make_osmesa_context();
/// The context of a window, which must outlive it.
std::unique_ptr<Context> make_window_context(GLFWwindow* window);

/// The sentence for a driver that refuses 4.5. `renderer` and `version` may be empty when nothing could be
/// asked.
std::string too_old_message(ContextKind kind, std::string_view renderer, std::string_view version);

}  // namespace sl::gl
