// SPDX-License-Identifier: MIT
#include "game/hall/cloth.h"

#include <algorithm>

namespace sl {

namespace {

constexpr double tau = 2.0 * glm::pi<double>();

}  // namespace

HallMesh curtain(const ClothShape& shape, const HallDetail& detail) {
    HallMesh mesh;
    const SurfaceGrid grid{.across = detail.steps(66, 6), .along = detail.steps(18, 3), .size = {shape.width, shape.length}};
    // Coarse cloth has fewer: each takes some steps to be seen.
    const double folds = std::min(shape.folds, grid.across / 6.0);
    add_surface(mesh, grid, [&](double u, double v) {
        const double down = 1.0 - v, fold = tau * folds * u + shape.phase;
        // Folds wander, and are gathered less tightly further down.
        const double wander = 0.6 * std::sin(2.3 * u * tau + shape.phase) * down;
        const double z = (0.05 + 0.07 * down) * std::sin(fold + wander) + 0.02 * std::sin(2.0 * fold - wander) + 0.1 * down * down * std::sin(0.5 * tau * u + shape.phase);
        const double hem = 0.03 * std::cos(fold) * down;
        return dvec3((u - 0.5) * shape.width * (0.94 + 0.06 * down), -down * shape.length + hem, z);
    });
    return mesh;
}

HallMesh awning(const ClothShape& shape, double sag, const HallDetail& detail) {
    HallMesh mesh;
    const SurfaceGrid grid{.across = detail.steps(48, 8), .along = detail.steps(24, 4), .size = {shape.width, shape.length}};
    add_surface(mesh, grid, [&](double u, double v) {
        const double from_middle = 2.0 * u - 1.0, hanging = 1.0 - from_middle * from_middle;
        const double wave = 0.08 * std::sin(tau * shape.folds * v + shape.phase) * (0.4 + hanging) + 0.04 * std::sin(tau * (2.0 * u + v) + shape.phase);
        // Its edges hang lower, as nothing holds them.
        const double edge = 0.25 * (2.0 * v - 1.0) * (2.0 * v - 1.0) * hanging;
        return dvec3(0.5 * shape.width * from_middle, -sag * hanging + wave - edge, -(v - 0.5) * shape.length);
    });
    return mesh;
}

}  // namespace sl
