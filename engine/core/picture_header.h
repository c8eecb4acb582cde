// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "engine/core/math.h"

namespace sl {

/// What a picture's file says of itself, read before the library that decodes it sees it: libraries take as much memory as a file
/// claims to need, and find out later that it is cut or lies.
struct PictureHeader {
    const char* format = nullptr;  ///< as OpenImageIO calls it: "png", "jpeg", "webp", "openexr"; null for all else
    uvec2 size{0};                 ///< pixels; 0 where it cannot be told, and for EXR, whose parts each have one
};

/// Throws Error "NAME: …" where a part of a PNG claims more bytes than the file has.
PictureHeader picture_header(std::string_view bytes, const std::string& name);

}  // namespace sl
