// SPDX-License-Identifier: MIT
#include "game/voxel/raycast.h"

#include <cmath>
#include <limits>

namespace sl {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Span {
    double enter = 0.0;
    double leave = infinity;
    int axis = -1;  ///< through whose face the ray enters; -1 where it starts inside
};

/// Where a ray (in blocks) runs inside a box; enter >= leave where it misses.
Span clip(dvec3 origin, dvec3 direction, ivec3 low, ivec3 high) {
    Span span;
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) {
            if (origin[axis] < low[axis] || origin[axis] >= high[axis]) span.leave = -1.0;
            continue;
        }
        double near = (low[axis] - origin[axis]) / direction[axis];
        double far = (high[axis] - origin[axis]) / direction[axis];
        if (near > far) std::swap(near, far);
        if (near > span.enter) {
            span.enter = near;
            span.axis = axis;
        }
        span.leave = std::min(span.leave, far);
    }
    return span;
}

bool finite(vec3 v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace

// Amanatides and Woo 1987: the ray's next crossing is kept per axis, and the nearest of the three says which
// way to step.
std::optional<VoxelHit> raycast(const VoxelVolume& volume, vec3 origin_local, vec3 direction,
                                float max_distance, Block free) {
    if (!finite(origin_local) || !finite(direction) || direction == vec3(0.0f)) return std::nullopt;
    if (!(max_distance >= 0.0f)) return std::nullopt;
    const double size = volume.block_size();
    const dvec3 origin = dvec3(origin_local) / size;
    const dvec3 along = glm::normalize(dvec3(direction));
    const ivec3 low = volume.low();
    const ivec3 high = volume.high();
    const Span inside = clip(origin, along, low, high);
    const double end = std::min(inside.leave, static_cast<double>(max_distance) / size);

    double travelled = inside.enter;
    if (!(inside.enter < inside.leave) || travelled > end) return std::nullopt;
    ivec3 cell(0);
    ivec3 step(0);
    dvec3 crossing(infinity);
    const dvec3 start = origin + travelled * along;
    for (int axis = 0; axis < 3; ++axis) {
        // A start on a face belongs to the cell that the ray is about to cross.
        const double first = along[axis] < 0.0 ? std::ceil(start[axis]) - 1.0 : std::floor(start[axis]);
        // Clamped in floating point: rounding at the box's face may land one cell outside.
        cell[axis] = static_cast<int>(glm::clamp(first, double(low[axis]), double(high[axis] - 1)));
        if (along[axis] == 0.0) continue;
        step[axis] = along[axis] > 0.0 ? 1 : -1;
        crossing[axis] = (cell[axis] + (step[axis] > 0 ? 1 : 0) - origin[axis]) / along[axis];
    }
    ivec3 normal(0);
    if (inside.axis >= 0) normal[inside.axis] = -step[inside.axis];
    while (travelled <= end) {
        if (const Block block = volume.get(cell); block != Block::air && block != free) {
            return VoxelHit{block, cell, normal, static_cast<float>(travelled * size),
                            vec3((origin + travelled * along) * size)};
        }
        int axis = crossing.x < crossing.y ? 0 : 1;
        if (crossing.z < crossing[axis]) axis = 2;
        travelled = crossing[axis];
        cell[axis] += step[axis];
        // From the grid, not by adding up: a long ray must not drift off its line.
        crossing[axis] = (cell[axis] + (step[axis] > 0 ? 1 : 0) - origin[axis]) / along[axis];
        normal = ivec3(0);
        normal[axis] = -step[axis];
    }
    return std::nullopt;
}

}  // namespace sl
