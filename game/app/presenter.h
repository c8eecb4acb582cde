// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/math.h"
#include "engine/render/gl/gl.h"

namespace sl {

/// Copies finished pictures to the window. A picture is sRGB-encoded already, and so are widgets: nothing
/// encodes again between begin and end.
class Presenter {
  public:
    Presenter();
    ~Presenter();
    Presenter(const Presenter&) = delete;
    Presenter& operator=(const Presenter&) = delete;

    /// Binds the window's framebuffer of `size` pixels and makes it black.
    void begin(uvec2 size);
    /// Fills it with a picture, scaled where its size differs.
    void show(GLuint texture, uvec2 texture_size, uvec2 size);
    /// Only the part between two shares of the width, from the left.
    void show_part(GLuint texture, uvec2 texture_size, uvec2 size, float from, float to);
    /// Back to what the renderer's passes rely on.
    void end();

  private:
    GLuint framebuffer_ = 0;
};

}  // namespace sl
