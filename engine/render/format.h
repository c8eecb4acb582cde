// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace sl {

/// Pixel formats that passes use; the GL layer maps each to its internal format.
enum class Format : std::uint8_t { rgba8, srgb8_alpha8, rg8, rg16, r16f, rgba16f, r32f, rg32f, rgba32f, r32ui, rg32ui, depth32f };

/// Whether images of it are depth buffers.
constexpr bool is_depth(Format format) { return format == Format::depth32f; }

/// Bytes per pixel.
constexpr std::uint32_t bytes_per_pixel(Format format) {
    switch (format) {
        case Format::rg8:
        case Format::r16f: return 2;
        case Format::rgba8:
        case Format::srgb8_alpha8:
        case Format::rg16:
        case Format::r32f:
        case Format::r32ui:
        case Format::depth32f: return 4;
        case Format::rgba16f:
        case Format::rg32f:
        case Format::rg32ui: return 8;
        case Format::rgba32f: return 16;
    }
    return 0;
}

/// A 2D image or, with layers > 0, a 2D array of images.
struct TextureDesc {
    std::uint32_t width = 1;
    std::uint32_t height = 1;
    std::uint32_t layers = 0;
    std::uint32_t mips = 1;
    Format format = Format::rgba8;

    bool operator==(const TextureDesc&) const = default;
};

}  // namespace sl
