// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "game/voxel/blocks.h"

namespace sl {

inline constexpr int block_texture_size = 16;

/// One texel before it gets its colour.
struct PatternTexel {
    int light = 256;  ///< linear brightness, 256 = as given by the colour
    int accent = 0;   ///< share of the second colour, 0 to 256
};

/// The drawing of a layer at column x from the left and row y from the bottom, both 0 to 15.
using BlockPattern = PatternTexel (*)(std::uint32_t seed, int x, int y);

/// Linear colour in 1/1000.
struct PatternColour {
    int red = 0;
    int green = 0;
    int blue = 0;
};

struct LayerDesign {
    BlockPattern pattern = nullptr;
    PatternColour base;
    PatternColour accent;
};

const LayerDesign& layer_design(BlockLayer layer);

}  // namespace sl
