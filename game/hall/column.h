// SPDX-License-Identifier: MIT
#pragma once

#include "game/hall/hall_detail.h"
#include "game/hall/hall_mesh.h"

namespace sl {

struct ColumnShape {
    double height, radius;  ///< m; the radius is that of the shaft at its foot
    double abacus;          ///< half a side of the slab on top, m
};

/// On the ground at 0: a square plinth, a round base, a fluted shaft that narrows, a capital of two rows of leaves.
HallMesh column(const ColumnShape& shape, const HallDetail& detail);

}  // namespace sl
