// SPDX-License-Identifier: MIT
#pragma once

#include "game/hall/hall_detail.h"
#include "game/hall/hall_mesh.h"

namespace sl {

/// Half an ellipse over what it spans, from 0 up.
struct VaultShape {
    double x, z;  ///< what it spans, m
    double rise;  ///< m
};

/// Two barrels that cross over a bay, seen from below; its corners are at 0.
HallMesh groin_vault(const VaultShape& shape, const HallDetail& detail);

/// An arch below a vault, that spans x and is z thick.
HallMesh rib(const VaultShape& shape, const HallDetail& detail);

}  // namespace sl
