// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "engine/core/picture_header.h"

namespace sl {

/// "image/png"; empty for pictures that glTF and its extensions do not know.
std::string_view gltf_media_type(PictureCoding coding);
/// The other way round; unknown for all else.
PictureCoding gltf_picture_coding(std::string_view media_type);

}  // namespace sl
