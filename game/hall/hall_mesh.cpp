// SPDX-License-Identifier: MIT
#include "game/hall/hall_mesh.h"

#include <algorithm>

namespace sl {

namespace {

constexpr double least_area = 1e-10;  // m²: where a side shrinks to a point, half of the triangles there are none
// As a share of a surface: normals at its edges are those just inside, where no side is without length.
constexpr double inside = 1e-5;

dvec3 normal_of(const Surface& at, double u, double v) {
    constexpr double half = 0.5 * inside;
    const double x = std::clamp(u, inside, 1.0 - inside), y = std::clamp(v, inside, 1.0 - inside);
    return glm::cross(at(x + half, y) - at(x - half, y), at(x, y + half) - at(x, y - half));
}

void add_triangle(HallMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const dvec3 from(mesh.positions[a]);
    if (0.5 * glm::length(glm::cross(dvec3(mesh.positions[b]) - from, dvec3(mesh.positions[c]) - from)) < least_area) return;
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

}  // namespace

void add_surface(HallMesh& mesh, const SurfaceGrid& grid, const Surface& at, const Surface& normal) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size()), row = static_cast<std::uint32_t>(grid.across + 1);
    for (int j = 0; j <= grid.along; ++j) {
        for (int i = 0; i <= grid.across; ++i) {
            const double u = static_cast<double>(i) / grid.across, v = static_cast<double>(j) / grid.along;
            mesh.positions.emplace_back(at(u, v));
            mesh.normals.emplace_back(glm::normalize(normal ? normal(u, v) : normal_of(at, u, v)));
            mesh.uvs.emplace_back(dvec2(u, 1.0 - v) * grid.size / texture_side);
        }
    }
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(grid.along); ++j) {
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t corner = first + j * row + i;
            add_triangle(mesh, corner, corner + 1, corner + row + 1);
            add_triangle(mesh, corner, corner + row + 1, corner + row);
        }
    }
}

void add_rectangle(HallMesh& mesh, dvec3 corner, dvec3 right, dvec3 up) {
    add_surface(mesh, {.size = {glm::length(right), glm::length(up)}}, [=](double u, double v) { return corner + u * right + v * up; });
}

void add_box(HallMesh& mesh, dvec3 low, dvec3 high) {
    const dvec3 size = high - low, x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
    add_rectangle(mesh, low + z, x, y);
    add_rectangle(mesh, low + x, -x, y);
    add_rectangle(mesh, high - y, -z, y);
    add_rectangle(mesh, low, z, y);
    add_rectangle(mesh, low + y + z, x, -z);
    add_rectangle(mesh, low, x, z);
}

void add_tube(HallMesh& mesh, const TubeWay& way, int around, int along) {
    const auto forward = [&](double v) {
        constexpr double half = 0.5 * inside;
        const double middle = std::clamp(v, inside, 1.0 - inside);
        return glm::normalize(way.at(middle + half) - way.at(middle - half));
    };
    const Surface at = [&](double u, double v) {
        const dvec3 ahead = forward(v), across = glm::normalize(glm::cross(ahead, way.side(v))), side = glm::cross(across, ahead);
        const double angle = 2.0 * glm::pi<double>() * u;
        return way.at(v) + way.radius * (std::cos(angle) * side + std::sin(angle) * across);
    };
    // Two derivatives of a way leave too few digits for a third.
    const Surface normal = [&](double u, double v) { return at(u, v) - way.at(v); };
    add_surface(mesh, {.across = around, .along = along, .size = {texture_side, way.length}}, at, normal);
}

}  // namespace sl
