// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_media_type.h"

#include <algorithm>
#include <array>

namespace sl {

namespace {

struct Entry {
    PictureCoding coding;
    std::string_view media_type;
};
constexpr std::array entries{Entry{PictureCoding::png, "image/png"}, Entry{PictureCoding::jpeg, "image/jpeg"}, Entry{PictureCoding::webp, "image/webp"}, Entry{PictureCoding::ktx2, "image/ktx2"}};

}  // namespace

std::string_view gltf_media_type(PictureCoding coding) {
    const auto found = std::ranges::find(entries, coding, &Entry::coding);
    return found == entries.end() ? std::string_view() : found->media_type;
}

PictureCoding gltf_picture_coding(std::string_view media_type) {
    const auto found = std::ranges::find(entries, media_type, &Entry::media_type);
    return found == entries.end() ? PictureCoding::unknown : found->coding;
}

}  // namespace sl
