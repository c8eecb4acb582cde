// SPDX-License-Identifier: MIT
#include "engine/render/gl/texture.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/core/check.h"
#include "engine/core/srgb.h"
#include "engine/render/gl/label.h"

namespace sl::gl {
namespace {

GLsizei size(std::uint32_t value) {
    return static_cast<GLsizei>(value);
}

}  // namespace

FormatNames format_names(Format format) {
    switch (format) {
        case Format::rgba8:
            return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
        case Format::srgb8_alpha8:
            return {GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE};
        case Format::rg8:
            return {GL_RG8, GL_RG, GL_UNSIGNED_BYTE};
        case Format::rg16:
            return {GL_RG16, GL_RG, GL_UNSIGNED_SHORT};
        case Format::r16f:
            return {GL_R16F, GL_RED, GL_HALF_FLOAT};
        case Format::rgba16f:
            return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT};
        case Format::r32f:
            return {GL_R32F, GL_RED, GL_FLOAT};
        case Format::rg32f:
            return {GL_RG32F, GL_RG, GL_FLOAT};
        case Format::rgba32f:
            return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
        case Format::r32ui:
            return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT};
        case Format::rg32ui:
            return {GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT};
        case Format::depth32f:
            return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
    }
    CHECK(false, "unknown format {}", static_cast<int>(format));
}

std::uint32_t channel_count(Format format) {
    switch (format_names(format).layout) {
        case GL_RGBA:
            return 4;
        case GL_RG:
        case GL_RG_INTEGER:
            return 2;
        default:
            return 1;
    }
}

Texture::Texture(const TextureDesc& desc, const char* label) : desc_(desc) {
    CHECK(desc.width >= 1 && desc.height >= 1, "texture \"{}\" of {} x {}", label, desc.width, desc.height);
    const auto levels = static_cast<std::uint32_t>(std::bit_width(std::max(desc.width, desc.height)));
    CHECK(desc.mips >= 1 && desc.mips <= levels, "texture \"{}\" of {} x {} with {} mips", label, desc.width,
          desc.height, desc.mips);
    const GLenum internal = format_names(desc.format).internal;
    if (desc.layers == 0) {
        glCreateTextures(GL_TEXTURE_2D, 1, &id_);
        glTextureStorage2D(id_, size(desc.mips), internal, size(desc.width), size(desc.height));
    } else {
        glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &id_);
        glTextureStorage3D(id_, size(desc.mips), internal, size(desc.width), size(desc.height),
                           size(desc.layers));
    }
    glTextureParameteri(id_, GL_TEXTURE_MIN_FILTER, desc.mips > 1 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
    glTextureParameteri(id_, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTextureParameteri(id_, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(id_, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    set_label(GL_TEXTURE, id_, label);
}

Texture::~Texture() {
    if (id_ != 0) glDeleteTextures(1, &id_);
}

void Texture::upload(std::uint32_t mip, std::uint32_t layer, std::span<const std::byte> bytes) {
    CHECK(id_ != 0 && mip < desc_.mips && layer < std::max(desc_.layers, 1u), "no mip {} of layer {}", mip,
          layer);
    const std::uint32_t width = std::max(desc_.width >> mip, 1u);
    const std::uint32_t height = std::max(desc_.height >> mip, 1u);
    const std::size_t expected = std::size_t{width} * height * bytes_per_pixel(desc_.format);
    CHECK(bytes.size() == expected, "{} bytes for a mip of {}", bytes.size(), expected);
    const FormatNames names = format_names(desc_.format);
    if (desc_.layers == 0) {
        glTextureSubImage2D(id_, size(mip), 0, 0, size(width), size(height), names.layout, names.type,
                            bytes.data());
    } else {
        glTextureSubImage3D(id_, size(mip), 0, 0, size(layer), size(width), size(height), 1, names.layout,
                            names.type, bytes.data());
    }
}

std::vector<float> Texture::read(std::uint32_t layer) const { return read_region(uvec2(0), {desc_.width, desc_.height}, layer); }

std::vector<float> Texture::read_texel(uvec2 texel, std::uint32_t layer) const {
    CHECK(texel.x < desc_.width && texel.y < desc_.height, "no texel {}, {} in a texture of {}x{}", texel.x, texel.y, desc_.width, desc_.height);
    return read_region(texel, uvec2(1), layer);
}

std::vector<float> Texture::read_region(uvec2 from, uvec2 extent, std::uint32_t layer) const {
    CHECK(id_ != 0 && layer < std::max(desc_.layers, 1u), "no layer {} in a texture of {}", layer,
          desc_.layers);
    const FormatNames names = format_names(desc_.format);
    const std::uint32_t channels = channel_count(desc_.format);
    std::vector<float> values(std::size_t{extent.x} * extent.y * channels);
    const auto get = [&](GLenum type, void* out) {
        glGetTextureSubImage(id_, 0, size(from.x), size(from.y), size(layer), size(extent.x), size(extent.y), 1,
                             names.layout, type, static_cast<GLsizei>(values.size() * sizeof(float)), out);
    };
    if (names.type == GL_UNSIGNED_INT) {
        std::vector<std::uint32_t> whole(values.size());
        get(GL_UNSIGNED_INT, whole.data());
        std::transform(whole.begin(), whole.end(), values.begin(),
                       [](std::uint32_t v) { return static_cast<float>(v); });
        return values;
    }
    get(GL_FLOAT, values.data());
    if (desc_.format == Format::srgb8_alpha8) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (i % 4 != 3) values[i] = linear_from_srgb(values[i]);
        }
    }
    return values;
}

}  // namespace sl::gl
