// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/math.h"

namespace sl {

/// Float pixels, row 0 at the top, channels interleaved: data[(y * width + x) * channels + c].
struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t channels = 0;
    std::vector<float> data;

    Image() = default;
    /// All 0.
    Image(std::uint32_t width_, std::uint32_t height_, std::uint32_t channels_)
        : width(width_), height(height_), channels(channels_), data(std::size_t{width_} * height_ * channels_) {}

    /// Its first channel; the others follow. (0, 0) is the upper left.
    float* pixel(std::uint32_t x, std::uint32_t y) { return &data[(std::size_t{y} * width + x) * channels]; }
    const float* pixel(std::uint32_t x, std::uint32_t y) const { return const_cast<Image*>(this)->pixel(x, y); }
};

/// An image under a name in a multi-layer EXR; its channels become NAME.R, NAME.G, NAME.B, NAME.A (NAME.Y when single).
/// The layer named "" holds plain R, G, B, A.
struct ImageLayer {
    std::string name;
    Image image;
};

/// Writes all layers (same size) as 32-bit float EXR. Written beside and renamed: a failure leaves no half file.
/// `note` is any text, kept as an attribute. Throws Error naming the file.
void write_exr(const std::filesystem::path& path, const std::vector<ImageLayer>& layers, const std::string& note = {});
/// Reads every layer of an EXR. Throws Error naming the file and what is wrong.
std::vector<ImageLayer> read_exr(const std::filesystem::path& path);
/// The note of an EXR; empty when it has none. Throws like read_exr.
std::string read_exr_note(const std::filesystem::path& path);

/// Writes display-referred values in [0, 1] (already sRGB-encoded) as 8-bit PNG. Same guarantees as write_exr.
void write_png(const std::filesystem::path& path, const Image& image);
/// Reads a PNG into values in [0, 1] without changing their encoding. Throws like read_exr.
Image read_png(const std::filesystem::path& path);

/// Places pictures of one height side by side with a gap of `gap` white pixels.
Image side_by_side(const std::vector<Image>& images, std::uint32_t gap);

}  // namespace sl
