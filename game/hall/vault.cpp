// SPDX-License-Identifier: MIT
#include "game/hall/vault.h"

namespace sl {

namespace {

constexpr double rib_below = 0.1, rib_above = 0.15;  // m, from the vault

/// From the middle of the bay towards one of its sides: a quarter of it, as high as the barrel that leads there.
void add_web(HallMesh& mesh, dvec2 half, double rise, dvec3 outwards, dvec3 sideways, const HallDetail& detail) {
    const auto angle = [](double v) { return glm::pi<double>() * (v - 0.5); };
    const auto at = [&](double u, double v) {
        const double side = std::sin(angle(v)), out = glm::mix(std::abs(side), 1.0, u);
        return half.x * out * outwards + half.y * side * sideways + dvec3(0, rise * std::cos(angle(v)), 0);
    };
    // Where two barrels meet, the web has no width; its normal is the barrel's all the same.
    const auto normal = [&](double, double v) { return -std::sin(angle(v)) / half.y * sideways - dvec3(0, std::cos(angle(v)) / rise, 0); };
    add_surface(mesh, {.across = detail.steps(6, 1), .along = 2 * detail.steps(8, 3), .size = {half.x, 2.0 * half.y}}, at, normal);
}

}  // namespace

HallMesh groin_vault(const VaultShape& shape, const HallDetail& detail) {
    HallMesh mesh;
    const dvec2 along_x(0.5 * shape.x, 0.5 * shape.z), along_z(along_x.y, along_x.x);
    const dvec3 x(1, 0, 0), z(0, 0, 1);
    add_web(mesh, along_x, shape.rise, x, z, detail);
    add_web(mesh, along_z, shape.rise, z, -x, detail);
    add_web(mesh, along_x, shape.rise, -x, -z, detail);
    add_web(mesh, along_z, shape.rise, -z, x, detail);
    return mesh;
}

HallMesh rib(const VaultShape& shape, const HallDetail& detail) {
    HallMesh mesh;
    const double half = 0.5 * shape.x, depth = 0.5 * shape.z;
    const int round = 2 * detail.steps(12, 3);
    const auto point = [&](double u, double rise) {
        const double angle = glm::pi<double>() * (1.0 - u);
        return dvec2(half * std::cos(angle), rise * std::sin(angle));
    };
    const double below = shape.rise - rib_below;
    add_surface(mesh, {.across = round, .size = {shape.x, shape.z}}, [&](double u, double v) {
        const dvec2 low = point(u, below);
        return dvec3(low.x, low.y, glm::mix(-depth, depth, v));
    });
    for (const double side : {1.0, -1.0}) {
        add_surface(mesh, {.across = round, .size = {shape.x, rib_below + rib_above}}, [&](double u, double v) {
            const dvec2 low = point(u, below), high = point(u, shape.rise) + dvec2(0, rib_above);
            return dvec3(side * glm::mix(low.x, high.x, v), glm::mix(low.y, high.y, v), side * depth);
        });
    }
    return mesh;
}

}  // namespace sl
