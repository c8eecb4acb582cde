// SPDX-License-Identifier: MIT
#pragma once

#include "game/hall/hall_detail.h"
#include "game/hall/hall_mesh.h"

namespace sl {

/// Square tiles of 1 m with bevelled edges, their tops at 0 and one beside the other without gaps, on whole metres of x and z
/// from `low` to `high`.
HallMesh tiled_floor(ivec2 low, ivec2 high, const HallDetail& detail);

}  // namespace sl
