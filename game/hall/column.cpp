// SPDX-License-Identifier: MIT
#include "game/hall/column.h"

#include "game/hall/lathe.h"

namespace sl {

namespace {

constexpr int flutes = 20;
constexpr double narrowing = 0.15, flute_depth = 0.08;  // of the radius
constexpr double tau = 2.0 * glm::pi<double>();

/// Each flute is a surface of its own, so that the edges between them are sharp.
void add_shaft(HallMesh& mesh, double radius, double foot, double top, const HallDetail& detail) {
    const SurfaceGrid grid{.across = detail.steps(5, 1), .along = detail.steps(10, 1), .size = {tau * radius / flutes, top - foot}};
    for (int flute = 0; flute < flutes; ++flute) {
        add_surface(mesh, grid, [&](double u, double v) {
            const double angle = tau * (flute + u) / flutes, hollow = 4.0 * u * (1.0 - u);
            const double here = radius * (1.0 - narrowing * v * v - flute_depth * hollow);
            return dvec3(here * std::sin(angle), foot + v * (top - foot), here * std::cos(angle));
        });
    }
}

/// A bell from the shaft's radius to almost that of the abacus, out of which leaves swell in two rows.
void add_bell(HallMesh& mesh, double narrow, double wide, dvec2 heights, const HallDetail& detail) {
    constexpr double leaves = 8.0;
    const SurfaceGrid grid{.across = detail.steps(56, 8), .along = detail.steps(12, 4), .size = {texture_side, heights.y - heights.x}};
    add_surface(mesh, grid, [&](double u, double v) {
        const double row = v < 0.5 ? 0.0 : 0.5, swelling = std::sin(tau * v);
        const double leaf = 0.5 + 0.5 * std::cos(tau * (leaves * u + row));
        const double here = narrow + (wide - narrow) * v * v + 0.12 * narrow * leaf * swelling * swelling;
        return dvec3(here * std::sin(tau * u), glm::mix(heights.x, heights.y, v), here * std::cos(tau * u));
    });
}

}  // namespace

HallMesh column(const ColumnShape& shape, const HallDetail& detail) {
    const double r = shape.radius, plinth = 0.45 * r, foot = 1.1 * r, capital = shape.height - 2.0 * r, top = shape.height - 0.35 * r;
    HallMesh mesh;
    add_box(mesh, {-1.25 * r, 0.0, -1.25 * r}, {1.25 * r, plinth, 1.25 * r});
    const int around = detail.steps(32, 8), bend = detail.steps(5, 1);
    add_lathe(mesh,
              {bent({1.05 * r, plinth}, {1.4 * r, 0.5 * (plinth + 0.8 * r)}, {1.08 * r, 0.8 * r}, bend), bent({1.08 * r, 0.8 * r}, {0.98 * r, 0.95 * r}, {1.06 * r, foot}, bend),
               straight({1.06 * r, foot}, {0.85 * r, foot})},
              around);
    add_shaft(mesh, r, foot, capital, detail);
    const double neck = (1.0 - narrowing) * r;
    add_lathe(mesh, {bent({0.7 * r, capital - 0.1 * r}, {1.25 * r, capital}, {0.7 * r, capital + 0.1 * r}, bend)}, around);
    add_bell(mesh, neck, 0.93 * shape.abacus, {capital, top}, detail);
    add_box(mesh, {-shape.abacus, top, -shape.abacus}, {shape.abacus, shape.height, shape.abacus});
    return mesh;
}

}  // namespace sl
