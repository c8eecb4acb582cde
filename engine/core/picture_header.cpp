// SPDX-License-Identifier: MIT
#include "engine/core/picture_header.h"

#include "engine/core/error.h"

namespace sl {

namespace {

/// Numbers of a file by where they stand; 0 beyond its end.
class Numbers {
  public:
    explicit Numbers(std::string_view bytes) : bytes_(bytes) {}

    std::uint32_t byte(std::size_t at) const { return at < bytes_.size() ? static_cast<unsigned char>(bytes_[at]) : 0u; }
    std::uint32_t high_first(std::size_t at, std::size_t count) const {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < count; ++i) value = value << 8 | byte(at + i);
        return value;
    }
    std::uint32_t low_first(std::size_t at, std::size_t count) const {
        std::uint32_t value = 0;
        for (std::size_t i = count; i > 0; --i) value = value << 8 | byte(at + i - 1);
        return value;
    }

  private:
    std::string_view bytes_;
};

/// Chunks of length, name, data and checksum.
uvec2 png_size(std::string_view bytes, const std::string& name) {
    const Numbers numbers(bytes);
    constexpr std::size_t signature = 8, length_and_name = 8, checksum = 4;
    for (std::size_t at = signature; bytes.size() - at >= length_and_name;) {
        const std::size_t length = numbers.high_first(at, 4), left = bytes.size() - at - length_and_name;
        if (length > left) fail("{}: it is cut or damaged: a part at byte {} has {} bytes, and {} are left", name, at, length, left);
        if (left - length < checksum || bytes.substr(at + 4, 4) == "IEND") break;
        at += length_and_name + length + checksum;
    }
    return {numbers.high_first(signature + length_and_name, 4), numbers.high_first(signature + length_and_name + 4, 4)};
}

/// Segments of a marker and a length, until the pixels begin.
uvec2 jpeg_size(std::string_view bytes) {
    const Numbers numbers(bytes);
    uvec2 size(0);
    for (std::size_t at = 2; at + 4 <= bytes.size();) {
        const std::uint32_t marker = numbers.byte(at + 1);
        const bool is_marker = numbers.byte(at) == 0xff && marker != 0x00 && marker != 0xff;
        const bool stands_alone = marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
        if (!is_marker || stands_alone) {
            at += is_marker ? 2 : 1;
            continue;
        }
        constexpr std::uint32_t tables = 0xc4, reserved = 0xc8, arithmetic = 0xcc, scan = 0xda;
        if (marker == scan) break;
        const bool is_frame = marker >= 0xc0 && marker <= 0xcf && marker != tables && marker != reserved && marker != arithmetic;
        if (is_frame) size = glm::max(size, uvec2(numbers.high_first(at + 7, 2), numbers.high_first(at + 5, 2)));
        at += 2 + numbers.high_first(at + 2, 2);
    }
    return size;
}

/// Of the first chunk, which says how large the whole is.
uvec2 webp_size(std::string_view bytes) {
    const Numbers numbers(bytes);
    const std::string_view kind = bytes.substr(12, 4);
    if (kind == "VP8X") return uvec2(numbers.low_first(24, 3), numbers.low_first(27, 3)) + 1u;
    if (kind == "VP8L") return uvec2(numbers.low_first(21, 4) & 0x3fffu, numbers.low_first(21, 4) >> 14 & 0x3fffu) + 1u;
    if (kind == "VP8 ") return uvec2(numbers.low_first(26, 2), numbers.low_first(28, 2)) & 0x3fffu;
    return uvec2(0);
}

}  // namespace

PictureHeader picture_header(std::string_view bytes, const std::string& name) {
    if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return {"png", png_size(bytes, name)};
    if (bytes.starts_with("\xff\xd8")) return {"jpeg", jpeg_size(bytes)};
    if (bytes.starts_with("RIFF") && bytes.size() >= 12 && bytes.substr(8, 4) == "WEBP") return {"webp", webp_size(bytes)};
    if (bytes.starts_with("\x76\x2f\x31\x01")) return {"openexr", uvec2(0)};
    return {};
}

}  // namespace sl
