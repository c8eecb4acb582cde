// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace sl {

/// Formats of pictures that glTF and its extensions know.
enum class GltfImageKind : std::uint8_t { unknown, png, jpeg, webp, ktx2 };

/// "image/png"; empty for unknown ones.
std::string_view gltf_media_type(GltfImageKind kind);
/// The other way round; unknown for all else.
GltfImageKind gltf_image_kind_of(std::string_view media_type);

/// What is known of a picture before it is decoded.
struct GltfImageHeader {
    GltfImageKind kind = GltfImageKind::unknown;
    std::uint32_t width = 0, height = 0;  ///< 0 where they are not read: all but PNG and JPEG
    std::string fault;                    ///< what is wrong with the header; empty: nothing
};

/// What a picture's first bytes say. Nothing is decoded.
GltfImageHeader read_gltf_image_header(std::span<const std::byte> bytes);

}  // namespace sl
