// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "engine/core/math.h"

namespace sl {

using glm::dvec2;

/// Triangles of one material; counter-clockwise is the front.
struct HallMesh {
    std::vector<vec3> positions;  ///< m
    std::vector<vec3> normals;    ///< unit, on the side of the front
    std::vector<vec2> uvs;        ///< 1 is `texture_side` of surface
    std::vector<std::uint32_t> indices;

    std::size_t triangles() const { return indices.size() / 3; }
};

/// What one repeat of a texture covers, m.
inline constexpr double texture_side = 2.0;

/// A vector for u and v of 0 to 1. A surface's front is seen where u runs to the right and v up.
using Surface = std::function<dvec3(double u, double v)>;

/// Into how many pieces a surface is cut, and how much of the texture it shows.
struct SurfaceGrid {
    int across = 1, along = 1;  ///< of u, of v
    dvec2 size{1.0};            ///< m
};

/// Normals are those of the surface, or of `normal`, whose length does not matter, where sides of it shrink to a point.
void add_surface(HallMesh& mesh, const SurfaceGrid& grid, const Surface& at, const Surface& normal = {});

/// From a corner to the right and up, as seen from its front.
void add_rectangle(HallMesh& mesh, dvec3 corner, dvec3 right, dvec3 up);

/// All six sides, from outside.
void add_box(HallMesh& mesh, dvec3 low, dvec3 high);

/// A tube round a way: `at` gives points for 0 to 1, `side` directions that are nowhere along it.
struct TubeWay {
    std::function<dvec3(double)> at, side;
    double radius = 0.0, length = 1.0;  ///< m
};
/// Without ends.
void add_tube(HallMesh& mesh, const TubeWay& way, int around, int along);

}  // namespace sl
