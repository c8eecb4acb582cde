// SPDX-License-Identifier: MIT
#include "game/hall/floor.h"
#include "game/hall/hall_plan.h"

namespace sl {

using namespace hall_plan;

namespace {

constexpr double thickness = 0.5, into = 0.05;  // m: of the outer walls, and how far floors reach into them

/// A floor round the court, between two heights.
HallMesh floor_round(double inner_x, double inner_z, double outer, dvec2 heights) {
    HallMesh mesh;
    const double x = wall_x + outer, z = wall_z + outer;
    add_box(mesh, {inner_x, heights.x, -z}, {x, heights.y, z});
    add_box(mesh, {-x, heights.x, -z}, {-inner_x, heights.y, z});
    add_box(mesh, {-inner_x, heights.x, inner_z}, {inner_x, heights.y, z});
    add_box(mesh, {-inner_x, heights.x, -z}, {inner_x, heights.y, -inner_z});
    return mesh;
}

HallMesh outer_walls() {
    HallMesh mesh;
    const double low = -thickness, high = ceiling + into, x = wall_x + thickness, z = wall_z + thickness;
    add_box(mesh, {wall_x, low, -z}, {x, high, z});
    add_box(mesh, {-x, low, -z}, {-wall_x, high, z});
    add_box(mesh, {-wall_x, low, wall_z}, {wall_x, high, z});
    add_box(mesh, {-wall_x, low, -z}, {wall_x, high, -wall_z});
    return mesh;
}

/// Rounded from below, and as long as a bay so that it can be repeated: along x, towards +z.
HallMesh cornice(const HallDetail& detail) {
    HallMesh mesh;
    constexpr double height = 0.25, reach = 0.14, edge = 0.06;
    const double half = 0.5 * bay;
    add_surface(mesh, {.along = detail.steps(6, 2), .size = {bay, height}}, [&](double u, double v) {
        const double angle = 0.5 * glm::pi<double>() * v;
        return dvec3(glm::mix(-half, half, u), (height - edge) * (1.0 - std::cos(angle)), reach * std::sin(angle));
    });
    add_rectangle(mesh, {-half, height - edge, reach}, {bay, 0, 0}, {0, edge, 0});
    add_rectangle(mesh, {-half, height, reach}, {bay, 0, 0}, {0, 0, -reach});
    return mesh;
}

/// Along all four sides of the opening that a floor leaves, facing the court.
std::vector<HallPlace> round_opening(double x, double z, double height) {
    std::vector<HallPlace> places;
    const double quarter = 0.5 * glm::pi<double>();
    // At the ends the last ones reach into each other.
    for (int i = 0; i < bays_z; ++i) {
        const double along = (i + 0.5 - 0.5 * bays_z) * bay;
        places.push_back({{-x, height, along}, quarter});
        places.push_back({{x, height, along}, -quarter});
    }
    for (int i = 0; i < bays_x; ++i) {
        const double along = (i + 0.5 - 0.5 * bays_x) * bay;
        places.push_back({{along, height, -z}, 0.0});
        places.push_back({{along, height, z}, 2.0 * quarter});
    }
    return places;
}

/// Beams under the gallery's ceiling, from the arches to the walls.
HallMesh beams() {
    HallMesh mesh;
    constexpr double half = 0.09, depth = 0.24;
    for (int i = 0; i < 2 * static_cast<int>(wall_z); ++i) {
        const double z = i + 0.5 - wall_z;
        for (const double side : {-1.0, 1.0}) {
            const double inner = std::abs(z) < court_z ? court_x : 0.0, from = side < 0.0 ? -wall_x - into : inner, to = side < 0.0 ? -inner : wall_x + into;
            add_box(mesh, {from, ceiling - depth, z - half}, {to, ceiling + into, z + half});
        }
    }
    return mesh;
}

}  // namespace

void add_hall_shell(Hall& hall, const HallDetail& detail) {
    const auto add = [&](const char* name, HallSurface surface, HallMesh mesh, std::vector<HallPlace> places = {{}}) {
        hall.parts.push_back({name, static_cast<int>(surface), std::move(mesh), std::move(places)});
    };
    add("floor", HallSurface::tile, tiled_floor({-static_cast<int>(wall_x), -static_cast<int>(wall_z)}, {static_cast<int>(wall_x), static_cast<int>(wall_z)}, detail));
    HallMesh ground;
    add_box(ground, {-wall_x - thickness, -thickness, -wall_z - thickness}, {wall_x + thickness, -0.1, wall_z + thickness});
    add("ground", HallSurface::plaster, std::move(ground));
    add("outer walls", HallSurface::plaster, outer_walls());
    add("gallery floor", HallSurface::stone, floor_round(court_x - ledge, court_z - ledge, into, {gallery_below, gallery}));
    add("roof", HallSurface::plaster, floor_round(hall_opening_high.x, hall_opening_high.z, thickness + 0.1, {ceiling, roof}));
    std::vector<HallPlace> places = round_opening(court_x - ledge, court_z - ledge, gallery_below + 0.05);
    const auto upper = round_opening(hall_opening_high.x, hall_opening_high.z, ceiling + 0.1);
    places.insert(places.end(), upper.begin(), upper.end());
    add("cornice", HallSurface::marble, cornice(detail), std::move(places));
    add("beams", HallSurface::wood, beams());
}

}  // namespace sl
