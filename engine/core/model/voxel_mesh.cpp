// SPDX-License-Identifier: MIT
#include "engine/core/model/voxel_mesh.h"

#include <limits>

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

MeshData voxel_mesh(const VoxelGrid& grid, vec3 low) {
    MeshData mesh;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int sign : {1, -1}) {
            const Side side{axis, sign};
            const int width = grid.size[side.u()], height = grid.size[side.v()];
            std::vector<std::uint8_t> faces(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
            MeshData::Facing facing{.axis = axis, .sign = static_cast<float>(sign), .first = static_cast<std::uint32_t>(mesh.indices.size()), .count = 0, .lowest = std::numeric_limits<float>::infinity()};
            for (int slice = 0; slice < grid.size[axis]; ++slice) {
                ivec3 cell(slice), step(0);
                step[axis] = sign;
                for (cell[side.v()] = 0; cell[side.v()] < height; ++cell[side.v()]) {
                    for (cell[side.u()] = 0; cell[side.u()] < width; ++cell[side.u()]) {
                        cell[axis] = slice;
                        faces[static_cast<std::size_t>(cell[side.v()]) * static_cast<std::size_t>(width) + static_cast<std::size_t>(cell[side.u()])] = grid.at(cell + step) == 0 ? grid.at(cell) : std::uint8_t{0};
                    }
                }
                const int plane = slice + (sign > 0 ? 1 : 0);
                merge(faces, width, height, [&](Rectangle area, std::uint8_t number) {
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
