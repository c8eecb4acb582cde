// SPDX-License-Identifier: MIT
#pragma once

#include "game/hall/hall_detail.h"
#include "game/hall/hall_mesh.h"

namespace sl {

struct ClothShape {
    double width, length;  ///< m
    double folds;          ///< how many
    double phase;          ///< rad, of the folds
};

/// Hangs from y = 0 across x, in folds towards z that grow on the way down.
HallMesh curtain(const ClothShape& shape, const HallDetail& detail);

/// Hung between two ends of `width` along x, so that its middle is `sag` lower; `length` along z, with a few waves.
HallMesh awning(const ClothShape& shape, double sag, const HallDetail& detail);

}  // namespace sl
