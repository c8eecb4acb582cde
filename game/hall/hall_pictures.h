// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "engine/core/image.h"

namespace sl {

/// What covers the hall, as sRGB of `texture_side` squared that repeats without a seam.

/// Light and dark tiles of 1 m with veins.
Image tile_picture(std::uint64_t seed);
/// Courses of cut stone.
Image stone_picture(std::uint64_t seed);
/// Grey woven cloth with stripes, for a material's colour to tint.
Image cloth_picture(std::uint64_t seed);

}  // namespace sl
