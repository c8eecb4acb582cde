// SPDX-License-Identifier: MIT
#include "engine/core/model/picture.h"

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/core/memory_reader.h"
#include "engine/core/picture_header.h"
#include "engine/core/srgb.h"

namespace sl {

namespace {

/// A picture whose header has been read; the image's bytes must outlive it.
struct OpenPicture {
    std::unique_ptr<MemoryReader> reader;
    std::unique_ptr<OIIO::ImageInput> input;
};

void check_picture_size(const ModelImage& image, std::uint64_t width, std::uint64_t height) {
    if (width > 0 && height > 0 && std::max(width, height) <= widest_picture && width * height <= most_picture_pixels) return;
    fail("{}: a picture of {} x {} is more than is read", image.name, width, height);
}

OpenPicture open_picture(const ModelImage& image) {
    const PictureHeader header = picture_header({reinterpret_cast<const char*>(image.bytes.data()), image.bytes.size()}, image.name);
    if (header.format == nullptr || std::string_view(header.format) == "openexr") fail("{}: it is no PNG, JPEG or WebP", image.name);
    check_picture_size(image, header.size.x, header.size.y);
    OpenPicture open{.reader = std::make_unique<MemoryReader>(image.bytes.data(), image.bytes.size()), .input = OIIO::ImageInput::create(header.format)};
    if (open.input == nullptr) fail("{}: pictures of this format ({}) cannot be read here", image.name, header.format);
    OIIO::ImageSpec config, spec;
    // Colours are not multiplied by their alpha.
    config.attribute("oiio:UnassociatedAlpha", 1);
    if (!open.input->set_ioproxy(open.reader.get()) || !open.input->open(image.name, spec, config)) {
        const std::string why = for_message(open.input->geterror());
        fail("{}: it cannot be read as a picture: {}", image.name, why);
    }
    // The library may have found another header than we did.
    check_picture_size(image, static_cast<std::uint64_t>(std::max(spec.width, 0)), static_cast<std::uint64_t>(std::max(spec.height, 0)));
    if (spec.nchannels < 1) fail("{}: it has no channels", image.name);
    return open;
}

float decoded(std::uint8_t value) {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> linear{};
        for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
        return linear;
    }();
    return table[value];
}

std::uint8_t byte_of(float value) { return static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f))); }

std::uint8_t encoded(float linear) { return byte_of(srgb_from_linear(std::clamp(linear, 0.0f, 1.0f))); }

/// Of floats, red, green, blue and alpha.
OIIO::ImageBuf resized(const OIIO::ImageBuf& from, std::uint32_t size, bool smooth) {
    const auto side = static_cast<int>(size);
    const OIIO::ROI square(0, side, 0, side, 0, 1, 0, 4);
    OIIO::ImageBuf result = smooth ? OIIO::ImageBufAlgo::resize(from, "triangle", 0.0f, square) : OIIO::ImageBufAlgo::resample(from, false, square);
    if (result.has_error()) fail("a picture cannot be made {} x {}: {}", size, size, for_message(result.geterror()));
    return result;
}

}  // namespace

uvec2 picture_size(const ModelImage& image) {
    const OpenPicture open = open_picture(image);
    return {open.input->spec().width, open.input->spec().height};
}

Picture decode_picture(const ModelImage& image) {
    const OpenPicture open = open_picture(image);
    const OIIO::ImageSpec spec = open.input->spec();
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    Picture picture{.width = static_cast<std::uint32_t>(spec.width), .height = static_cast<std::uint32_t>(spec.height), .pixels = {}};
    const std::size_t count = std::size_t{picture.width} * picture.height;
    std::vector<std::uint8_t> read(count * channels);
    if (!open.input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::UINT8, read.data())) {
        const std::string why = for_message(open.input->geterror());
        fail("{}: it cannot be decoded: {}", image.name, why);
    }
    picture.pixels.resize(count * 4);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* from = &read[i * channels];
        std::uint8_t* to = &picture.pixels[4 * i];
        const bool grey = channels < 3;
        for (std::size_t k = 0; k < 3; ++k) to[k] = from[grey ? 0 : k];
        to[3] = channels == 2 ? from[1] : channels >= 4 ? from[3] : 255;
    }
    return picture;
}

std::uint32_t picture_mips(std::uint32_t size) { return static_cast<std::uint32_t>(std::bit_width(size)); }

std::vector<std::uint8_t> picture_layer(const Picture& picture, std::uint32_t size, PictureKind kind, bool smooth) {
    const bool colour = kind == PictureKind::colour;
    std::vector<float> linear(picture.pixels.size());
    for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = colour && i % 4 != 3 ? decoded(picture.pixels[i]) : static_cast<float>(picture.pixels[i]) / 255.0f;
    const OIIO::ImageBuf whole(OIIO::ImageSpec(static_cast<int>(picture.width), static_cast<int>(picture.height), 4, OIIO::TypeDesc::FLOAT), linear.data());
    OIIO::ImageBuf level = resized(whole, size, smooth);
    std::vector<std::uint8_t> bytes;
    std::vector<float> pixels;
    for (std::uint32_t side = size; side > 0; side /= 2) {
        if (side != size) level = resized(level, side, true);
        pixels.resize(std::size_t{side} * side * 4);
        if (!level.get_pixels(level.roi(), OIIO::TypeDesc::FLOAT, pixels.data())) fail("a picture cannot be read again: {}", for_message(level.geterror()));
        for (std::size_t i = 0; i < pixels.size(); ++i) bytes.push_back(colour && i % 4 != 3 ? encoded(pixels[i]) : byte_of(pixels[i]));
    }
    return bytes;
}

}  // namespace sl
