// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_image_header.h"

#include <algorithm>
#include <array>

namespace sl {

namespace {

struct KindEntry {
    GltfImageKind kind;
    std::string_view media_type, magic;
};
using namespace std::string_view_literals;
constexpr std::array kinds{KindEntry{GltfImageKind::png, "image/png", "\x89PNG\r\n\x1a\n"sv},
                           KindEntry{GltfImageKind::jpeg, "image/jpeg", "\xff\xd8\xff"sv},
                           KindEntry{GltfImageKind::webp, "image/webp", "RIFF"sv},
                           KindEntry{GltfImageKind::ktx2, "image/ktx2", "\xabKTX 20\xbb\r\n\x1a\n"sv}};

constexpr std::string_view truncated = "ends within its header";

/// Reads numbers from a header, and tells when there are no more.
class Bytes {
  public:
    explicit Bytes(std::span<const std::byte> bytes) : bytes_(bytes) {}

    bool has(std::size_t at, std::size_t count) const { return at <= bytes_.size() && count <= bytes_.size() - at; }
    std::uint32_t at(std::size_t index) const { return std::to_integer<std::uint32_t>(bytes_[index]); }
    std::uint32_t big_16(std::size_t index) const { return at(index) << 8 | at(index + 1); }
    std::uint32_t big_32(std::size_t index) const { return big_16(index) << 16 | big_16(index + 2); }
    std::uint32_t little_32(std::size_t index) const {
        return at(index) | at(index + 1) << 8 | at(index + 2) << 16 | at(index + 3) << 24;
    }
    bool is(std::size_t index, std::string_view text) const {
        if (!has(index, text.size())) return false;
        return std::equal(text.begin(), text.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(index),
                          [](char c, std::byte byte) { return static_cast<std::byte>(c) == byte; });
    }

  private:
    std::span<const std::byte> bytes_;
};

void check_size(GltfImageHeader& header) {
    if (header.width == 0 || header.height == 0) header.fault = "has no pixels";
}

void read_png(const Bytes& bytes, GltfImageHeader& header) {
    constexpr std::size_t header_bytes = 33;
    if (!bytes.has(0, header_bytes)) {
        header.fault = truncated;
    } else if (!bytes.is(8, std::string_view("\0\0\0\rIHDR", 8))) {
        header.fault = "does not begin with the chunk IHDR";
    } else {
        header.width = bytes.big_32(16);
        header.height = bytes.big_32(20);
        check_size(header);
    }
}

/// Goes from segment to segment until one tells the size.
void read_jpeg(const Bytes& bytes, GltfImageHeader& header) {
    constexpr std::uint32_t mark = 0xFF, frame = 0xC0, last_frame = 0xCF, scan = 0xDA, end = 0xD9;
    constexpr std::array<std::uint32_t, 3> no_frames{0xC4, 0xC8, 0xCC};
    std::size_t at = 2;
    while (bytes.has(at, 4)) {
        if (bytes.at(at) != mark) break;
        const std::uint32_t marker = bytes.at(at + 1);
        if (marker == mark) {
            ++at;
            continue;
        }
        const std::uint32_t length = bytes.big_16(at + 2);
        if (marker < frame || marker == scan || marker == end || length < 2) break;
        const bool is_other = std::find(no_frames.begin(), no_frames.end(), marker) != no_frames.end();
        if (marker <= last_frame && !is_other) {
            if (!bytes.has(at, 9)) break;
            header.height = bytes.big_16(at + 5);
            header.width = bytes.big_16(at + 7);
            if (header.width == 0) header.fault = "has no pixels";
            return;
        }
        at += 2 + length;
    }
    header.fault = bytes.has(at, 9) ? "is no JPEG after its first bytes" : truncated;
}

void read_webp(const Bytes& bytes, GltfImageHeader& header) {
    constexpr std::size_t header_bytes = 20;
    if (!bytes.has(0, header_bytes)) {
        header.fault = truncated;
    } else if (!bytes.is(8, "WEBP")) {
        header.kind = GltfImageKind::unknown;
    } else if (!bytes.is(12, "VP8 ") && !bytes.is(12, "VP8L") && !bytes.is(12, "VP8X")) {
        header.fault = "holds no picture that WebP knows";
    } else if (!bytes.has(8, bytes.little_32(4))) {
        header.fault = "is shorter than its header says";
    }
}

}  // namespace

std::string_view gltf_media_type(GltfImageKind kind) {
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const KindEntry& entry) { return entry.kind == kind; });
    return found == kinds.end() ? std::string_view() : found->media_type;
}

GltfImageKind gltf_image_kind_of(std::string_view media_type) {
    const auto found =
        std::find_if(kinds.begin(), kinds.end(), [&](const KindEntry& entry) { return entry.media_type == media_type; });
    return found == kinds.end() ? GltfImageKind::unknown : found->kind;
}

GltfImageHeader read_gltf_image_header(std::span<const std::byte> span) {
    const Bytes bytes(span);
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const KindEntry& entry) { return bytes.is(0, entry.magic); });
    if (found == kinds.end()) return {};
    GltfImageHeader header{.kind = found->kind};
    constexpr std::size_t ktx2_header_bytes = 80;
    switch (header.kind) {
        case GltfImageKind::png: read_png(bytes, header); break;
        case GltfImageKind::jpeg: read_jpeg(bytes, header); break;
        case GltfImageKind::webp: read_webp(bytes, header); break;
        case GltfImageKind::ktx2:
            if (!bytes.has(0, ktx2_header_bytes)) header.fault = truncated;
            break;
        case GltfImageKind::unknown: break;
    }
    return header;
}

}  // namespace sl
