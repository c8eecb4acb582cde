// SPDX-License-Identifier: MIT
#include "engine/core/model/voxel_mesh.h"

#include <algorithm>
#include <limits>

#include "engine/core/error.h"

namespace sl {

namespace {

/// Faces that look one way along an axis. The other two axes follow in turn, so that u x v = axis.
struct Side {
    int axis, sign;
    int u() const { return (axis + 1) % 3; }
    int v() const { return (axis + 2) % 3; }
};

struct Rectangle {
    int u, v, width, height;
};

void append_quad(MeshData& mesh, const Side& side, int plane, Rectangle area, std::uint8_t number, vec3 low) {
    Vertex vertex;
    vec3 normal(0.0f);
    normal[side.axis] = static_cast<float>(side.sign);
    vertex.normal = pack_normal(normal);
    vertex.material = number - 1u;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const ivec2 corner : {ivec2(0, 0), ivec2(1, 0), ivec2(1, 1), ivec2(0, 1)}) {
        vertex.uv = vec2(area.u + corner.x * area.width, area.v + corner.y * area.height);
        vertex.position[side.axis] = static_cast<float>(plane);
        vertex.position[side.u()] = vertex.uv.x;
        vertex.position[side.v()] = vertex.uv.y;
        vertex.position += low;
        mesh.vertices.push_back(vertex);
        mesh.bounds.add(vertex.position);
    }
    const bool up = side.sign > 0;
    for (const std::uint32_t corner : {0u, up ? 1u : 2u, up ? 2u : 1u, 0u, up ? 2u : 3u, up ? 3u : 2u}) mesh.indices.push_back(first + corner);
}

/// The rows along x that hold anything: most of a large grid is empty.
struct FullRows {
    std::vector<std::vector<int>> by_y, by_z;  ///< the other coordinate of each

    explicit FullRows(const VoxelGrid& grid) : by_y(static_cast<std::size_t>(grid.size.y)), by_z(static_cast<std::size_t>(grid.size.z)) {
        auto row = grid.cells.begin();
        for (int z = 0; z < grid.size.z; ++z) {
            for (int y = 0; y < grid.size.y; ++y, row += grid.size.x) {
                if (std::all_of(row, row + grid.size.x, [](std::uint8_t cell) { return cell == 0; })) continue;
                by_y[static_cast<std::size_t>(y)].push_back(z);
                by_z[static_cast<std::size_t>(z)].push_back(y);
            }
        }
    }
};

/// Calls visit(cell) for all of a slice that may be full.
template <class Visit>
void each_in_slice(const VoxelGrid& grid, const FullRows& rows, int axis, int slice, Visit&& visit) {
    if (axis == 0) {
        for (int z = 0; z < grid.size.z; ++z) {
            for (const int y : rows.by_z[static_cast<std::size_t>(z)]) visit(ivec3(slice, y, z));
        }
        return;
    }
    for (const int other : (axis == 1 ? rows.by_y : rows.by_z)[static_cast<std::size_t>(slice)]) {
        for (int x = 0; x < grid.size.x; ++x) visit(axis == 1 ? ivec3(x, slice, other) : ivec3(x, other, slice));
    }
}

/// The numbers of full cells in a slice that have none before them on a side; whether there are any.
bool find_faces(const VoxelGrid& grid, const FullRows& rows, const Side& side, int slice, std::vector<std::uint8_t>& faces) {
    const int before = slice + side.sign;
    const bool is_outermost = before < 0 || before >= grid.size[side.axis];
    ivec3 step(0);
    step[side.axis] = 1;
    const auto to_before = side.sign * static_cast<std::ptrdiff_t>(grid.index(step));
    const auto width = static_cast<std::size_t>(grid.size[side.u()]);
    bool any = false;
    std::ranges::fill(faces, std::uint8_t{0});
    each_in_slice(grid, rows, side.axis, slice, [&](ivec3 cell) {
        const std::uint8_t* at = &grid.cells[grid.index(cell)];
        if (*at == 0 || (!is_outermost && at[to_before] != 0)) return;
        faces[static_cast<std::size_t>(cell[side.v()]) * width + static_cast<std::size_t>(cell[side.u()])] = *at;
        any = true;
    });
    return any;
}

/// Cuts a slice's faces into rectangles of one number, each as wide and then as high as it goes.
template <class Emit>
void merge(std::vector<std::uint8_t>& faces, int width, int height, Emit&& emit) {
    const auto at = [&](int u, int v) -> std::uint8_t& { return faces[static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u)]; };
    for (int v = 0; v < height; ++v) {
        for (int u = 0; u < width; ++u) {
            const std::uint8_t number = at(u, v);
            if (number == 0) continue;
            Rectangle area{u, v, 1, 1};
            while (u + area.width < width && at(u + area.width, v) == number) ++area.width;
            const auto goes_on = [&](int row) {
                for (int i = u; i < u + area.width; ++i) {
                    if (at(i, row) != number) return false;
                }
                return true;
            };
            while (v + area.height < height && goes_on(v + area.height)) ++area.height;
            for (int row = v; row < v + area.height; ++row) {
                for (int i = u; i < u + area.width; ++i) at(i, row) = 0;
            }
            emit(area, number);
        }
    }
}

}  // namespace

MeshData voxel_mesh(const VoxelGrid& grid, vec3 low, std::size_t& faces_left) {
    MeshData mesh;
    const FullRows rows(grid);
    for (int axis = 0; axis < 3; ++axis) {
        for (const int sign : {1, -1}) {
            const Side side{axis, sign};
            const int width = grid.size[side.u()], height = grid.size[side.v()];
            std::vector<std::uint8_t> faces(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
            MeshData::Facing facing{.axis = axis, .sign = static_cast<float>(sign), .first = static_cast<std::uint32_t>(mesh.indices.size()), .count = 0, .lowest = std::numeric_limits<float>::infinity()};
            for (int slice = 0; slice < grid.size[axis]; ++slice) {
                if (!find_faces(grid, rows, side, slice, faces)) continue;
                const int plane = slice + (sign > 0 ? 1 : 0);
                merge(faces, width, height, [&](Rectangle area, std::uint8_t number) {
                    if (faces_left == 0) fail("its voxels have more than {} faces", most_voxel_faces);
                    --faces_left;
                    append_quad(mesh, side, plane, area, number, low);
                    facing.lowest = std::min(facing.lowest, facing.sign * (static_cast<float>(plane) + low[axis]));
                });
            }
            facing.count = static_cast<std::uint32_t>(mesh.indices.size()) - facing.first;
            if (facing.count > 0) mesh.facings.push_back(facing);
        }
    }
    return mesh;
}

}  // namespace sl
