// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/image.h"
#include "engine/render/gl/texture.h"

namespace sl {

/// A picture on the GPU, as the screen shows it.
struct ShownPicture {
    GLuint texture = 0;  ///< 0: there is none
    uvec2 size{0};
};

/// A picture that is not the renderer's own: uploaded from the CPU when it changes.
class UploadedPicture {
  public:
    /// Values in [0, 1], sRGB-encoded, top row first; the first three channels.
    void upload(const Image& picture);
    ShownPicture shown() const { return {texture_.id(), {texture_.desc().width, texture_.desc().height}}; }
    explicit operator bool() const { return static_cast<bool>(texture_); }
    void clear() { texture_ = {}; }

  private:
    gl::Texture texture_;
};

}  // namespace sl
