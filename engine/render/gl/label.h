// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string_view>

#include "engine/render/gl/gl.h"

namespace sl::gl {

/// Names an object for debuggers and driver messages. Long labels are cut: 256 bytes is what every driver
/// takes.
inline void set_label(GLenum kind, GLuint id, std::string_view label) {
    if (!label.empty()) {
        glObjectLabel(kind, id, static_cast<GLsizei>(std::min<std::size_t>(label.size(), 255)), label.data());
    }
}

}  // namespace sl::gl
