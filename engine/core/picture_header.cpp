// SPDX-License-Identifier: MIT
#include "engine/core/picture_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace sl {

namespace {

using namespace std::string_view_literals;

constexpr std::string_view truncated = "ends within its header";

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

void read_png(std::string_view bytes, PictureHeader& header) {
    const Numbers numbers(bytes);
    constexpr std::size_t signature = 8, length_and_name = 8, checksum = 4, header_bytes = 33;
    if (bytes.size() < header_bytes) {
        header.fault = truncated;
        return;
    }
    if (bytes.substr(signature, length_and_name) != "\0\0\0\rIHDR"sv) {
        header.fault = "does not begin with the chunk IHDR";
        return;
    }
    header.size = {numbers.high_first(signature + length_and_name, 4), numbers.high_first(signature + length_and_name + 4, 4)};
    if (header.size.x == 0 || header.size.y == 0) header.fault = "has no pixels";
    // Chunks of length, name, data and checksum.
    for (std::size_t at = signature; bytes.size() - at >= length_and_name;) {
        const std::size_t length = numbers.high_first(at, 4), left = bytes.size() - at - length_and_name;
        if (length > left) {
            header.fault = fmt::format("is cut or damaged: a part at byte {} has {} bytes, and {} are left", at, length, left);
            return;
        }
        if (left - length < checksum || bytes.substr(at + 4, 4) == "IEND") return;
        at += length_and_name + length + checksum;
    }
}

/// Of a JPEG, from the first on. Behind a mark the bytes of pixels have a zero.
std::size_t count_scans(std::string_view bytes) {
    std::size_t scans = 0;
    for (std::size_t at = bytes.find('\xff'); at != std::string_view::npos && at + 1 < bytes.size(); at = bytes.find('\xff', at + 1)) {
        if (bytes[at + 1] == '\xd9') break;
        if (bytes[at + 1] == '\xda') ++scans;
    }
    return scans;
}

/// Segments of a marker and a length, until the pixels begin.
void read_jpeg(std::string_view bytes, PictureHeader& header) {
    const Numbers numbers(bytes);
    bool has_frame = false;
    for (std::size_t at = 2; at + 4 <= bytes.size();) {
        const std::uint32_t marker = numbers.byte(at + 1);
        const bool is_marker = numbers.byte(at) == 0xff && marker != 0x00 && marker != 0xff;
        const bool stands_alone = marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8);
        if (!is_marker || stands_alone) {
            at += is_marker ? 2 : 1;
            continue;
        }
        constexpr std::uint32_t tables = 0xc4, reserved = 0xc8, arithmetic = 0xcc, scan = 0xda;
        constexpr std::size_t frame_bytes = 9;
        if (marker == scan) {
            // Each goes over all pixels, in a few bytes where nothing changes. Programs that make pictures need about ten.
            constexpr std::size_t most_scans = 64;
            if (const std::size_t scans = count_scans(bytes.substr(at)); scans > most_scans) header.fault = fmt::format("has {} scans; {} are the limit", scans, most_scans);
            break;
        }
        const bool is_frame = marker >= 0xc0 && marker <= 0xcf && marker != tables && marker != reserved && marker != arithmetic;
        if (is_frame && bytes.size() - at >= frame_bytes) {
            header.size = glm::max(header.size, uvec2(numbers.high_first(at + 7, 2), numbers.high_first(at + 5, 2)));
            has_frame = true;
        }
        at += 2 + numbers.high_first(at + 2, 2);
    }
    if (!has_frame) header.fault = "is no JPEG after its first bytes";
    // The height may follow behind the pixels.
    if (has_frame && header.size.x == 0) header.fault = "has no pixels";
}

/// The first chunk says how large the whole is.
void read_webp(std::string_view bytes, PictureHeader& header) {
    const Numbers numbers(bytes);
    const std::string_view kind = bytes.substr(12, 4);
    if (kind == "VP8X") {
        header.size = uvec2(numbers.low_first(24, 3), numbers.low_first(27, 3)) + 1u;
    } else if (kind == "VP8L") {
        header.size = uvec2(numbers.low_first(21, 4) & 0x3fffu, numbers.low_first(21, 4) >> 14 & 0x3fffu) + 1u;
    } else if (kind == "VP8 ") {
        header.size = uvec2(numbers.low_first(26, 2), numbers.low_first(28, 2)) & 0x3fffu;
    } else {
        header.fault = kind.size() < 4 ? truncated : "holds no picture that WebP knows"sv;
        return;
    }
    constexpr std::size_t riff_bytes = 8, header_bytes = 20;
    if (bytes.size() < header_bytes) {
        header.fault = truncated;
    } else if (bytes.size() - riff_bytes < numbers.low_first(4, 4)) {
        header.fault = "is shorter than its header says";
    }
}

struct Entry {
    PictureCoding coding;
    std::string_view name, magic;
};
constexpr std::array entries{Entry{PictureCoding::png, "png", "\x89PNG\r\n\x1a\n"sv}, Entry{PictureCoding::jpeg, "jpeg", "\xff\xd8\xff"sv}, Entry{PictureCoding::webp, "webp", "RIFF"sv},
                             Entry{PictureCoding::ktx2, "ktx2", "\xabKTX 20\xbb\r\n\x1a\n"sv}, Entry{PictureCoding::openexr, "openexr", "\x76\x2f\x31\x01"sv}};

PictureCoding coding_of(std::string_view bytes) {
    const auto found = std::ranges::find_if(entries, [&](const Entry& entry) { return bytes.starts_with(entry.magic); });
    if (found == entries.end()) return PictureCoding::unknown;
    const bool is_other_riff = found->coding == PictureCoding::webp && (bytes.size() < 12 || bytes.substr(8, 4) != "WEBP");
    return is_other_riff ? PictureCoding::unknown : found->coding;
}

}  // namespace

std::string picture_coding_name(PictureCoding coding) {
    const auto found = std::ranges::find(entries, coding, &Entry::coding);
    return found == entries.end() ? std::string() : std::string(found->name);
}

PictureHeader picture_header(std::string_view bytes) {
    PictureHeader header{.coding = coding_of(bytes)};
    constexpr std::size_t ktx2_header_bytes = 80;
    switch (header.coding) {
        case PictureCoding::png: read_png(bytes, header); break;
        case PictureCoding::jpeg: read_jpeg(bytes, header); break;
        case PictureCoding::webp: read_webp(bytes, header); break;
        case PictureCoding::ktx2:
            if (bytes.size() < ktx2_header_bytes) header.fault = truncated;
            break;
        case PictureCoding::openexr:
        case PictureCoding::unknown: break;
    }
    return header;
}

}  // namespace sl
