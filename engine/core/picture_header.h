// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "engine/core/math.h"

namespace sl {

/// How a picture's file is made.
enum class PictureCoding : std::uint8_t { unknown, png, jpeg, webp, ktx2, openexr };

/// As OpenImageIO calls it: "png"; empty for unknown ones.
std::string picture_coding_name(PictureCoding coding);

/// What a picture's file says of itself, read before the library that decodes it sees it: libraries take as much memory as a file
/// claims to need, and find out later that it is cut or lies.
struct PictureHeader {
    PictureCoding coding = PictureCoding::unknown;
    uvec2 size{0};      ///< pixels; 0 where it cannot be told, and for EXR, whose parts each have one, and KTX 2
    std::string fault;  ///< why it cannot be decoded: "ends within its header"; empty: nothing is wrong so far
};

/// By a file's first bytes; nothing is decoded.
PictureHeader picture_header(std::string_view bytes);

}  // namespace sl
