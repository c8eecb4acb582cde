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
    const PictureHeader header = picture_header({reinterpret_cast<const char*>(image.bytes.data()), image.bytes.size()});
    const bool is_known = header.coding == PictureCoding::png || header.coding == PictureCoding::jpeg || header.coding == PictureCoding::webp;
    if (!is_known) fail("{}: it is no PNG, JPEG or WebP", image.name);
    if (!header.fault.empty()) fail("{}: it {}", image.name, header.fault);
    check_picture_size(image, header.size.x, header.size.y);
    OpenPicture open{.reader = std::make_unique<MemoryReader>(image.bytes.data(), image.bytes.size()), .input = OIIO::ImageInput::create(picture_coding_name(header.coding))};
    if (open.input == nullptr) fail("{}: pictures of this format ({}) cannot be read here", image.name, picture_coding_name(header.coding));
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

/// Of the pixels that fall together where the picture is made of `blocks`.
std::array<float, 4> mean_of_block(const Picture& picture, uvec2 block, uvec2 blocks, bool colour) {
    const auto first = [](std::uint32_t number, std::uint32_t size, std::uint32_t count) { return static_cast<std::uint32_t>(std::uint64_t{number} * size / count); };
    const std::uint32_t left = first(block.x, picture.width, blocks.x), right = first(block.x + 1, picture.width, blocks.x), top = first(block.y, picture.height, blocks.y),
                        bottom = first(block.y + 1, picture.height, blocks.y);
    std::array<float, 4> sum{};
    for (std::uint32_t y = top; y < bottom; ++y) {
        for (std::uint32_t x = left; x < right; ++x) {
            const std::uint8_t* pixel = &picture.pixels[4 * (std::size_t{y} * picture.width + x)];
            for (std::size_t k = 0; k < 4; ++k) sum[k] += colour && k != 3 ? decoded(pixel[k]) : static_cast<float>(pixel[k]) / 255.0f;
        }
    }
    for (float& number : sum) number /= static_cast<float>((right - left) * (bottom - top));
    return sum;
}

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
    constexpr int most_channels = 4;
    picture.pixels.assign(count * most_channels, 255);
    if (!open.input->read_image(0, 0, 0, std::min(spec.nchannels, most_channels), OIIO::TypeDesc::UINT8, picture.pixels.data(), most_channels)) {
        const std::string why = for_message(open.input->geterror());
        fail("{}: it cannot be decoded: {}", image.name, why);
    }
    for (std::size_t i = 0; channels < 3 && i < count; ++i) {
        std::uint8_t* pixel = &picture.pixels[4 * i];
        if (channels == 2) pixel[3] = pixel[1];
        pixel[1] = pixel[2] = pixel[0];
    }
    return picture;
}

std::uint32_t picture_mips(std::uint32_t size) { return static_cast<std::uint32_t>(std::bit_width(size)); }

std::vector<std::uint8_t> picture_layer(const Picture& picture, std::uint32_t size, PictureKind kind, bool smooth) {
    const bool colour = kind == PictureKind::colour;
    // Floats of all pixels of a large picture would take a gigabyte, so blocks of them are averaged first.
    const std::uint32_t width = smooth ? picture.width / std::max(picture.width / size, 1u) : picture.width, height = smooth ? picture.height / std::max(picture.height / size, 1u) : picture.height;
    std::vector<float> linear(std::size_t{width} * height * 4);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const std::array<float, 4> mean = mean_of_block(picture, uvec2(x, y), uvec2(width, height), colour);
            std::ranges::copy(mean, linear.begin() + static_cast<std::ptrdiff_t>(4 * (std::size_t{y} * width + x)));
        }
    }
    const OIIO::ImageBuf whole(OIIO::ImageSpec(static_cast<int>(width), static_cast<int>(height), 4, OIIO::TypeDesc::FLOAT), linear.data());
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
