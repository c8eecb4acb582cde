// SPDX-License-Identifier: MIT
#pragma once

#include <memory>

#include "engine/render/gl/texture.h"
#include "engine/render/renderer.h"

namespace sl {

/// What one side of a comparison shows. Methods follow: `method` + n is the n-th of gi_method_names().
enum class CompareSource : std::size_t { live, frozen, reference, error, method };

std::string compare_source_name(CompareSource source);
std::size_t compare_source_count();

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

/// One side's source, and the renderer that draws another method than the live one for it.
class CompareSide {
  public:
    CompareSource source = CompareSource::live;

    /// Draws the same scene by this side's method, if it has one of its own.
    void draw(RenderScene scene, const Renderer::Request& request);
    ShownPicture drawn();

  private:
    std::unique_ptr<Renderer> renderer_;  ///< while the source is a method
    Renderer::Result result_;
    uvec2 size_{0};
};

}  // namespace sl
