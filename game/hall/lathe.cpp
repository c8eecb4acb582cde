// SPDX-License-Identifier: MIT
#include "game/hall/lathe.h"

#include <algorithm>
#include <cmath>

namespace sl {

OutlinePiece straight(dvec2 from, dvec2 to) {
    return {.at = [=](double t) { return from + t * (to - from); }};
}

OutlinePiece bent(dvec2 from, dvec2 towards, dvec2 to, int steps) {
    return {.at = [=](double t) { return (1.0 - t) * (1.0 - t) * from + 2.0 * t * (1.0 - t) * towards + t * t * to; }, .steps = steps};
}

void add_lathe(HallMesh& mesh, const std::vector<OutlinePiece>& outline, int around) {
    for (const OutlinePiece& piece : outline) {
        const dvec2 first = piece.at(0.0), last = piece.at(1.0);
        // A whole number of repeats, so that the texture has no seam.
        const double repeats = std::max(1.0, std::round(2.0 * glm::pi<double>() * std::max(first.x, last.x) / texture_side));
        add_surface(mesh, {.across = around, .along = piece.steps, .size = {repeats * texture_side, glm::length(last - first)}}, [&](double u, double v) {
            const double angle = 2.0 * glm::pi<double>() * u;
            const dvec2 point = piece.at(v);
            return dvec3(point.x * std::sin(angle), point.y, point.x * std::cos(angle));
        });
    }
}

}  // namespace sl
