// SPDX-License-Identifier: MIT
#include "game/hall/floor.h"

namespace sl {

namespace {

constexpr double groove = 0.012, depth = 0.01;  // m: half its width, and how deep it is

/// One of four sides of a tile's edge, as a quarter of a circle in as many steps; none: the tile is flat.
void add_bevel(HallMesh& mesh, dvec3 middle, dvec3 out, int steps) {
    const dvec3 along(-out.z, 0, out.x);
    add_surface(mesh, {.across = steps, .size = {groove, 1.0}}, [&](double u, double v) {
        const double angle = 0.5 * glm::pi<double>() * u, inset = groove * (1.0 - std::sin(angle));
        return middle + (0.5 - inset) * (out + (1.0 - 2.0 * v) * along) - dvec3(0, depth * (1.0 - std::cos(angle)), 0);
    });
}

}  // namespace

HallMesh tiled_floor(ivec2 low, ivec2 high, const HallDetail& detail) {
    HallMesh mesh;
    const int steps = detail.steps(1, 0);
    const double inset = steps > 0 ? groove : 0.0, side = 1.0 - 2.0 * inset;
    for (int z = low.y; z < high.y; ++z) {
        for (int x = low.x; x < high.x; ++x) {
            const auto first = mesh.uvs.size();
            add_rectangle(mesh, {x + inset, 0.0, z + 1 - inset}, {side, 0, 0}, {0, 0, -side});
            for (const dvec3 out : {dvec3(1, 0, 0), dvec3(0, 0, 1), dvec3(-1, 0, 0), dvec3(0, 0, -1)}) {
                if (steps > 0) add_bevel(mesh, {x + 0.5, 0.0, z + 0.5}, out, steps);
            }
            // One picture lies over the whole floor.
            for (auto i = first; i < mesh.uvs.size(); ++i) mesh.uvs[i] = vec2(mesh.positions[i].x, mesh.positions[i].z) / static_cast<float>(texture_side);
        }
    }
    return mesh;
}

}  // namespace sl
