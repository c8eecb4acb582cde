// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/math.h"
#include "engine/render/format.h"
#include "engine/render/gl/gl.h"
#include "engine/render/program_desc.h"

namespace sl::gl {

/// How a format is spelled in GL.
struct FormatNames {
    GLenum internal;
    GLenum layout;
    GLenum type;
};
/// What OpenGL calls a format.
FormatNames format_names(Format format);

/// Owns an immutable 2D texture or 2D array texture (desc.layers > 0). Nearest, clamped to edge by default.
class Texture {
  public:
    Texture() = default;
    explicit Texture(const TextureDesc& desc, const char* label = "");
    ~Texture();
    Texture(Texture&& other) noexcept { swap(other); }
    Texture& operator=(Texture&& other) noexcept {
        swap(other);
        return *this;
    }

    GLuint id() const { return id_; }
    const TextureDesc& desc() const { return desc_; }
    explicit operator bool() const { return id_ != 0; }

    /// Fills one mip of one layer; `bytes` holds width × height pixels of the format's own layout, bottom
    /// row first.
    void upload(std::uint32_t mip, std::uint32_t layer, std::span<const std::byte> bytes);
    /// Reads one layer of mip 0 as floats (channels as the format has them, depth as 1), bottom row first.
    /// sRGB colours come decoded, as a shader sees them. Slow.
    std::vector<float> read(std::uint32_t layer = 0) const;
    /// The same of one texel, counted from the bottom left.
    std::vector<float> read_texel(uvec2 texel, std::uint32_t layer = 0) const;

  private:
    std::vector<float> read_region(uvec2 from, uvec2 extent, std::uint32_t layer) const;
    void swap(Texture& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(desc_, other.desc_);
    }
    GLuint id_ = 0;
    TextureDesc desc_;
};

/// Number of channels that Texture::read returns per pixel.
std::uint32_t channel_count(Format format);

/// Sampler objects shared by all passes, one per Sampling. Lives until the context ends.
class Samplers {
  public:
    Samplers();
    ~Samplers();
    Samplers(const Samplers&) = delete;
    Samplers& operator=(const Samplers&) = delete;
    GLuint id(Sampling sampling) const { return ids_[static_cast<int>(sampling)]; }

  private:
    GLuint ids_[5] = {};
};

}  // namespace sl::gl
