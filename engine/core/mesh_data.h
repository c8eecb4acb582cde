// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/core/math.h"
#include "engine/core/slot_map.h"

namespace sl {

/// One vertex as the GPU reads it, 32 bytes.
struct Vertex {
    vec3 position;                       ///< metres, local space
    std::uint32_t normal = 0;            ///< pack_normal
    vec2 uv{0.0f};                       ///< texture repeats at whole numbers
    std::uint32_t material = 0;          ///< added to the draw's first material
    std::uint32_t colour = 0xffffffffu;  ///< RGBA8, linear, multiplies the base colour
};
static_assert(sizeof(Vertex) == 32);

/// What else a vertex has where its material's pictures need it, 16 bytes.
struct PicturedVertex {
    vec2 uv{0.0f};              ///< second texture coordinates
    std::uint32_t tangent = 0;  ///< pack_normal: where the normal texture's right lies, along the surface
    float hand = 1.0f;          ///< 1 or -1: its top lies towards hand * cross(normal, tangent)
};
static_assert(sizeof(PicturedVertex) == 16);

/// Triangles as plain arrays; counter-clockwise is the front.
struct MeshData {
    /// A run of indices whose triangles all face the same way along an axis. From below the lowest none is seen.
    struct Facing {
        int axis;
        float sign;  ///< 1: up the axis, -1: down
        std::uint32_t first, count;
        float lowest;  ///< sign times the position along the axis, m
    };

    std::vector<Vertex> vertices;
    std::vector<PicturedVertex> pictured;  ///< one per vertex, or none
    std::vector<std::uint32_t> indices;
    std::vector<Facing> facings;  ///< all indices, in order; or empty, and triangles face anywhere
    bool both_sides = false;  ///< each triangle is there twice, the second time turned
    Bounds bounds;
    std::uint32_t version = 0;  ///< whoever changes the arrays counts this up, so that caches notice
    Bounds changed;             ///< where its surface differs from the last version's; empty: anywhere
};

/// Names a mesh of the MeshPool.
using MeshHandle = Handle<MeshData>;
/// All meshes of a world, a resource.
using MeshPool = SlotMap<MeshData>;

}  // namespace sl
