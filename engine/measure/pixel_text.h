// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "engine/core/image.h"

// Labels in pictures: a font of 5 × 7 pixels for digits, letters (all drawn as capitals) and . , : % + - > < ( ) /.
// Anything else becomes an empty box.

namespace sl {

inline constexpr std::uint32_t text_height = 7;

/// Width in pixels at scale 1; 0 for no text.
std::uint32_t text_width(std::string_view text);

/// Draws with the top left corner at (x, y), each dot of the font `scale` pixels wide; what lies outside is cut off.
/// The picture has at least 3 channels.
void draw_text(Image& picture, std::int64_t x, std::int64_t y, std::uint32_t scale, vec3 colour, std::string_view text);

}  // namespace sl
