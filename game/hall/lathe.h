// SPDX-License-Identifier: MIT
#pragma once

#include "game/hall/hall_mesh.h"

namespace sl {

/// A piece of an outline: radius and height for 0 to 1, m.
struct OutlinePiece {
    std::function<dvec2(double)> at;
    int steps = 1;
};

OutlinePiece straight(dvec2 from, dvec2 to);
/// A quadratic Bézier curve.
OutlinePiece bent(dvec2 from, dvec2 towards, dvec2 to, int steps);

/// An outline turned round the y axis, with an edge between any two pieces. The front is to the right of its way: outside,
/// where it leads up.
void add_lathe(HallMesh& mesh, const std::vector<OutlinePiece>& outline, int around);

}  // namespace sl
