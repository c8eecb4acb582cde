// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/shape_mesh.h"

#include <cmath>

namespace sl {

namespace {

constexpr std::uint32_t slices = 64;
constexpr std::uint32_t stacks = 32;

void add_vertex(MeshData& mesh, vec3 position, vec3 normal, vec2 uv) {
    mesh.vertices.push_back({.position = position, .normal = pack_normal(normal), .uv = uv});
    mesh.bounds.add(position);
}

void add_triangle(MeshData& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
}

/// A rectangle round `centre`, spanned by `half_u` and `half_v`, seen from where their cross product points.
void add_face(MeshData& mesh, vec3 centre, vec3 half_u, vec3 half_v, vec3 normal) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    add_vertex(mesh, centre - half_u - half_v, normal, {0, 0});
    add_vertex(mesh, centre + half_u - half_v, normal, {1, 0});
    add_vertex(mesh, centre + half_u + half_v, normal, {1, 1});
    add_vertex(mesh, centre - half_u + half_v, normal, {0, 1});
    add_triangle(mesh, first, first + 1, first + 2);
    add_triangle(mesh, first, first + 2, first + 3);
}

vec3 along(int axis, float length) {
    vec3 vector(0.0f);
    vector[axis] = length;
    return vector;
}

void add_box(MeshData& mesh, vec3 half) {
    for (int axis = 0; axis < 3; ++axis) {
        const int next = (axis + 1) % 3, last = (axis + 2) % 3;
        const vec3 u = along(next, half[next]), v = along(last, half[last]);
        add_face(mesh, along(axis, half[axis]), u, v, along(axis, 1.0f));
        add_face(mesh, along(axis, -half[axis]), v, u, along(axis, -1.0f));
    }
}

/// (sine, cosine); the last point of a turn is bit for bit the first, so that meshes close.
vec2 on_circle(std::uint32_t slice) {
    const double angle = 2.0 * 3.14159265358979323846 * (slice % slices) / slices;
    return {static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle))};
}

void add_disc(MeshData& mesh, vec3 half) {
    add_vertex(mesh, vec3(0.0f), vec3(0, 1, 0), {0.5f, 0.5f});
    for (std::uint32_t slice = 0; slice < slices; ++slice) {
        const vec2 rim = on_circle(slice);
        add_vertex(mesh, half * vec3(rim.x, 0, rim.y), vec3(0, 1, 0),
                   {0.5f + 0.5f * rim.x, 0.5f - 0.5f * rim.y});
        add_triangle(mesh, 0, 1 + slice, 1 + (slice + 1) % slices);
    }
}

vec3 ellipsoid_normal(vec3 direction, vec3 half) {
    const vec3 normal = direction * vec3(half.y * half.z, half.x * half.z, half.x * half.y);
    const float length = glm::length(normal);
    return length > 0.0f && std::isfinite(length) ? normal / length : direction;
}

void add_sphere(MeshData& mesh, vec3 half) {
    for (std::uint32_t stack = 0; stack <= stacks; ++stack) {
        const double angle = 3.14159265358979323846 * stack / stacks;
        const bool pole = stack == 0 || stack == stacks;
        const float ring = pole ? 0.0f : static_cast<float>(std::sin(angle));
        const auto height = static_cast<float>(std::cos(angle));
        for (std::uint32_t slice = 0; slice <= slices; ++slice) {
            const vec2 round = ring * on_circle(slice);
            const vec3 direction(round.x, height, round.y);
            const vec2 uv(static_cast<float>(slice) / slices, 1.0f - static_cast<float>(stack) / stacks);
            add_vertex(mesh, half * direction, ellipsoid_normal(direction, half), uv);
            if (stack == stacks || slice == slices) continue;
            const std::uint32_t a = stack * (slices + 1) + slice, b = a + slices + 1;
            if (stack > 0) add_triangle(mesh, a, b, a + 1);
            if (stack + 1 < stacks) add_triangle(mesh, a + 1, b, b + 1);
        }
    }
}

void add_octahedron(MeshData& mesh, vec3 half) {
    for (int octant = 0; octant < 8; ++octant) {
        const vec3 side((octant & 1) != 0 ? -1.0f : 1.0f, (octant & 2) != 0 ? -1.0f : 1.0f, (octant & 4) != 0 ? -1.0f : 1.0f);
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        const vec3 normal = ellipsoid_normal(glm::normalize(side), half);
        for (int axis = 0; axis < 3; ++axis) add_vertex(mesh, along(axis, side[axis] * half[axis]), normal, axis == 0 ? vec2(0, 0) : axis == 1 ? vec2(1, 0) : vec2(0.5f, 1.0f));
        const bool turned = side.x * side.y * side.z < 0.0f;
        add_triangle(mesh, first, first + (turned ? 2 : 1), first + (turned ? 1 : 2));
    }
}

}  // namespace

MeshData make_shape_mesh(const Shape& shape) {
    MeshData mesh;
    vec3 half = 0.5f * shape.size;
    for (int axis = 0; axis < 3; ++axis)
        half[axis] = std::isfinite(half[axis]) ? std::max(half[axis], 0.0f) : 0.0f;
    switch (shape.kind) {
        case Shape::Kind::box:
            add_box(mesh, half);
            break;
        case Shape::Kind::quad:
            add_face(mesh, vec3(0.0f), along(2, half.z), along(0, half.x), vec3(0, 1, 0));
            break;
        case Shape::Kind::disc:
            add_disc(mesh, half);
            break;
        case Shape::Kind::sphere:
            add_sphere(mesh, half);
            break;
        case Shape::Kind::octahedron:
            add_octahedron(mesh, half);
            break;
    }
    return mesh;
}

}  // namespace sl
