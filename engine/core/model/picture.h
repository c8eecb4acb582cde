// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/model/model.h"

namespace sl {

/// Pixels of 8 bits, red, green, blue, alpha; top row first.
struct Picture {
    std::uint32_t width = 1, height = 1;
    std::vector<std::uint8_t> pixels{255, 255, 255, 255};
};

/// Widths, heights and pixels beyond this are refused before anything is decoded.
inline constexpr std::uint32_t widest_picture = 16384;
inline constexpr std::uint64_t most_picture_pixels = std::uint64_t{1} << 26;

/// What a picture's header says. Throws Error that names it where that is nothing that can be decoded, or too much.
uvec2 picture_size(const ModelImage& image);
/// Throws like picture_size, and where the picture ends too soon.
Picture decode_picture(const ModelImage& image);

/// What its numbers mean.
enum class PictureKind {
    colour,  ///< sRGB, averaged as light
    data     ///< averaged as it is
};
/// A picture as a square layer of a texture with all its mips down to 1 x 1, whatever its own size. `smooth` false: its texels stay squares.
std::vector<std::uint8_t> picture_layer(const Picture& picture, std::uint32_t size, PictureKind kind, bool smooth);
/// How many mips that are.
std::uint32_t picture_mips(std::uint32_t size);

}  // namespace sl
