// SPDX-License-Identifier: MIT
#pragma once

#include "game/hall/hall_detail.h"
#include "game/hall/hall_mesh.h"

namespace sl {

/// A piece of wall along x with a round opening in its middle, standing on the heads of two columns.
struct ArchShape {
    double width;      ///< from column to column, m
    double thickness;  ///< m
    double radius;     ///< of the opening, m
    double height;     ///< from where it springs to its top, m
};

/// The columns' heads are at 0. Its ends, where the next one begins, and its top are open.
HallMesh arch(const ArchShape& shape, const HallDetail& detail);

}  // namespace sl
