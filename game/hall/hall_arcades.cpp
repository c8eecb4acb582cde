// SPDX-License-Identifier: MIT
#include <cmath>

#include "game/hall/arch.h"
#include "game/hall/column.h"
#include "game/hall/furniture.h"
#include "game/hall/hall_plan.h"
#include "game/hall/vault.h"

namespace sl {

using namespace hall_plan;

namespace {

constexpr double quarter = 0.5 * glm::pi<double>(), into = 0.05;
constexpr double pier = 0.39, rib_width = 0.6;  // m; a pier is a little narrower than what rests on it
// Vaults reach into arches and walls on both sides.
constexpr double vault_inner = court_x + 0.25, vault_middle = 0.5 * (vault_inner + wall_x + into), vault_span = wall_x + into - vault_inner, vault_rise = 1.8;
// Of the court's long sides; the walk is as wide at its ends.
constexpr double to_end = court_z - court_x;

/// Where columns stand at a height: on the court's sides without its corners.
std::vector<HallPlace> between_corners(double height) {
    std::vector<HallPlace> places;
    for (int i = 1; i < bays_z; ++i) {
        for (const double side : {-1.0, 1.0}) places.push_back({{side * court_x, height, (i - 0.5 * bays_z) * bay}});
    }
    for (int i = 1; i < bays_x; ++i) {
        for (const double side : {-1.0, 1.0}) places.push_back({{(i - 0.5 * bays_x) * bay, height, side * court_z}});
    }
    return places;
}

/// The middle of each bay, `beyond` the columns' axes, with x along the court's side and z into the court.
std::vector<HallPlace> middles_of_bays(double height, double beyond) {
    std::vector<HallPlace> places;
    for (int i = 0; i < bays_z; ++i) {
        for (const double side : {-1.0, 1.0}) places.push_back({{side * (court_x + beyond), height, (i + 0.5 - 0.5 * bays_z) * bay}, -side * quarter});
    }
    for (int i = 0; i < bays_x; ++i) {
        for (const double side : {-1.0, 1.0}) places.push_back({{(i + 0.5 - 0.5 * bays_x) * bay, height, side * (court_z + beyond)}, side > 0.0 ? 2.0 * quarter : 0.0});
    }
    return places;
}

/// Where ribs cross the walk, in its middle, or pilasters stand at its walls; z as middles_of_bays has it. Those at its corners
/// stand a little aside, over the gap between two vaults.
std::vector<HallPlace> between_vaults(double height, double beyond) {
    std::vector<HallPlace> places;
    const double aside = 0.5 * (vault_inner - court_x);
    const auto along = [&](int i, int bays) { return (i - 0.5 * bays) * bay + (i == 0 ? -aside : i == bays ? aside : 0.0); };
    for (int i = 0; i <= bays_z; ++i) {
        for (const double side : {-1.0, 1.0}) places.push_back({{side * beyond, height, along(i, bays_z)}, -side * quarter});
    }
    for (int i = 0; i <= bays_x; ++i) {
        for (const double side : {-1.0, 1.0}) places.push_back({{along(i, bays_x), height, side * (to_end + beyond)}, side > 0.0 ? 2.0 * quarter : 0.0});
    }
    return places;
}

std::vector<HallPlace> corners(double x, double z, double height) {
    std::vector<HallPlace> places;
    for (const double side : {-1.0, 1.0}) {
        for (const double end : {-1.0, 1.0}) places.push_back({{side * x, height, end * z}});
    }
    return places;
}

HallMesh corner_pier() {
    HallMesh mesh;
    const auto slab = [&](double half, double low, double high) { add_box(mesh, {-half, low, -half}, {half, high, half}); };
    slab(pier, 0.0, ceiling + into);
    for (const double floor : {0.0, gallery}) slab(pier + 0.06, floor, floor + 0.25);
    for (const double head : {spring, upper_spring}) slab(pier + 0.05, head - 0.12, head);
    return mesh;
}

/// Against a wall at z = 0, towards +z.
HallMesh pilaster() {
    HallMesh mesh;
    const auto slab = [&](double half, double depth, double low, double high) { add_box(mesh, {-half, low, -into}, {half, high, depth}); };
    slab(0.28, 0.12, 0.0, spring);
    slab(0.34, 0.18, 0.0, 0.25);
    slab(0.36, 0.2, spring - 0.12, spring);
    return mesh;
}

/// Two rails of a bay, from column to column.
HallMesh rails() {
    HallMesh mesh;
    const double half = 0.5 * bay - 0.28, foot = 0.1, head = foot + baluster_height;
    add_box(mesh, {-half, 0.0, -0.1}, {half, foot, 0.1});
    add_box(mesh, {-half, head, -0.13}, {half, head + 0.13, 0.13});
    return mesh;
}

std::vector<HallPlace> balusters() {
    std::vector<HallPlace> places;
    constexpr int count = 8;
    for (const HallPlace& bay_place : middles_of_bays(gallery + 0.1, 0.0)) {
        const dvec3 along(std::cos(bay_place.turn), 0.0, -std::sin(bay_place.turn));
        for (int i = 0; i < count; ++i) places.push_back({bay_place.position + (0.4 * (i - 0.5 * (count - 1))) * along, bay_place.turn});
    }
    return places;
}

}  // namespace

void add_hall_arcades(Hall& hall, const HallDetail& detail) {
    const auto add = [&](const char* name, HallSurface surface, HallMesh mesh, std::vector<HallPlace> places) {
        hall.parts.push_back({name, static_cast<int>(surface), std::move(mesh), std::move(places)});
    };
    add("column", HallSurface::marble, column({.height = spring, .radius = 0.32, .abacus = 0.4}, detail), between_corners(0.0));
    add("upper column", HallSurface::marble, column({.height = upper_spring - gallery, .radius = 0.24, .abacus = 0.4}, detail), between_corners(gallery));
    add("pier", HallSurface::stone, corner_pier(), corners(court_x, court_z, 0.0));
    const ArchShape lower{.width = bay, .thickness = lower_wall, .radius = arch_radius, .height = gallery_below + into - spring};
    const ArchShape upper{.width = bay, .thickness = upper_wall, .radius = arch_radius, .height = ceiling + into - upper_spring};
    add("arch", HallSurface::stone, arch(lower, detail), middles_of_bays(spring, 0.0));
    add("upper arch", HallSurface::stone, arch(upper, detail), middles_of_bays(upper_spring, 0.0));
    const VaultShape in_bay{.x = bay, .z = vault_span, .rise = vault_rise}, in_corner{.x = vault_span, .z = vault_span, .rise = vault_rise};
    add("vault", HallSurface::plaster, groin_vault(in_bay, detail), middles_of_bays(spring, vault_middle - court_x));
    add("corner vault", HallSurface::plaster, groin_vault(in_corner, detail), corners(vault_middle, to_end + vault_middle, spring));
    std::vector<HallPlace> ribs = between_vaults(spring, vault_middle);
    for (HallPlace& place : ribs) place.turn += quarter;
    add("rib", HallSurface::stone, rib({.x = vault_span, .z = rib_width, .rise = vault_rise}, detail), std::move(ribs));
    add("pilaster", HallSurface::stone, pilaster(), between_vaults(0.0, wall_x));
    add("rails", HallSurface::marble, rails(), middles_of_bays(gallery, 0.0));
    add("baluster", HallSurface::marble, baluster(detail), balusters());
}

}  // namespace sl
