// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/core/math.h"
#include "game/voxel/block_patterns.h"

namespace sl {

inline constexpr std::uint32_t block_texture_levels = 5;  ///< 16, 8, 4, 2, 1 texels wide

/// A square picture with its mip chain. Bytes are R, G, B, A per texel, colour sRGB-encoded, alpha 255. Row 0
/// is the BOTTOM row: uploaded as it is, GL's v = 0 is its lower edge, so v grows with +y on a block's side.
struct BlockTexture {
    std::array<std::vector<std::uint8_t>, block_texture_levels> mips;  ///< each averaged in linear light
};

/// Draws every layer, in the order of BlockLayer. The same seed gives the same bytes everywhere.
std::vector<BlockTexture> make_block_textures(std::uint32_t seed);

/// Mean linear colour of a layer as drawn.
vec3 average_albedo(const BlockTexture& texture);

}  // namespace sl
