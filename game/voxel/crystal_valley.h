// SPDX-License-Identifier: MIT
#pragma once

#include "game/voxel/voxel_volume.h"

/// Where things stand in the world that generate("crystal_valley") builds, in blocks. y = 0 is the grass' surface. Five
/// shrines stand round the meadow, each with a crystal that the entities of the scene "crystals" put there.
namespace sl::crystal_valley {

inline constexpr int meadow_half = 42;  ///< the ground is flat where |x| and |z| are less
inline constexpr int half = 56;         ///< the world is [-half, half) in x and z
inline constexpr int ground_low = -13;  ///< lowest layer

/// Cells in which the crystals stand.
inline constexpr ivec3 dawn{4, 0, -27};    ///< round a bend of a burrow
inline constexpr ivec3 ember{25, 0, -27};  ///< in a white hall under a skylight
inline constexpr ivec3 deep{26, -10, 26};  ///< in an orange cellar with a lamp
inline constexpr ivec3 moss{-20, -10, 16}; ///< at the foot of a well with a lid
inline constexpr ivec3 dusk{-38, 0, -27};  ///< behind a white hall, in a dark room

}  // namespace sl::crystal_valley
