// SPDX-License-Identifier: MIT
#include "game/voxel/mesher.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

namespace sl {
namespace {

constexpr int n = chunk_size;
constexpr std::array<int, 3> strides{1, n* n, n};  // of Chunk::index, by axis

/// One of the six ways to look at a block. right x up = normal, so a quad wound right, then up, faces
/// outward.
struct Direction {
    int axis, sign;
    int right, right_sign;
    int up, up_sign;
    BlockFace face;
};
constexpr std::array<Direction, 6> directions{{
    {0, +1, 2, -1, 1, +1, BlockFace::side},
    {0, -1, 2, +1, 1, +1, BlockFace::side},
    {1, +1, 0, +1, 2, -1, BlockFace::top},
    {1, -1, 0, +1, 2, +1, BlockFace::bottom},
    {2, +1, 0, +1, 1, +1, BlockFace::side},
    {2, -1, 0, -1, 1, +1, BlockFace::side},
}};

/// Which kinds of block a mesh shows, and which hide the faces before them.
struct FaceRule {
    std::array<bool, 256> shown{}, hides{};
};

FaceRule opaque_rule() {
    FaceRule rule;
    for (std::size_t block = 0; block < block_count; ++block) rule.shown[block] = block_info(static_cast<Block>(block)).opaque;
    rule.hides = rule.shown;
    return rule;
}

FaceRule water_rule() {
    constexpr auto water = static_cast<std::size_t>(Block::water);
    FaceRule rule{.shown = {}, .hides = opaque_rule().shown};
    rule.shown[water] = rule.hides[water] = true;
    return rule;
}

/// Blocks along each axis, one word per line of them: bit i + 1 is block i; bits 0 and 33 belong to the
/// neighbours. The line with coordinates (right, up) of the axis' directions is lines[axis][up * n + right].
struct Occupancy {
    std::array<std::array<std::uint64_t, n * n>, 3> lines{};

    void mark(int axis, int right, int up, int bit) {
        lines[static_cast<std::size_t>(axis)][static_cast<std::size_t>(up * n + right)] |= std::uint64_t{1}
                                                                                           << bit;
    }
    void mark_cell(int x, int y, int z) {
        mark(0, z, y, x + 1);
        mark(1, x, z, y + 1);
        mark(2, x, y, z + 1);
    }
};

std::size_t cell_index(const Direction& direction, int slice, int right, int up) {
    return static_cast<std::size_t>(slice * strides[static_cast<std::size_t>(direction.axis)] +
                                    right * strides[static_cast<std::size_t>(direction.right)] +
                                    up * strides[static_cast<std::size_t>(direction.up)]);
}

/// What is shown of the chunk, and what hides it, which reaches into the neighbours.
struct ChunkOccupancy {
    Occupancy shown, hides;
};

void gather(const VoxelVolume& volume, ivec3 key, const Chunk& chunk, const FaceRule& rule, ChunkOccupancy& occupancy) {
    for (int y = 0; y < n; ++y) {
        for (int z = 0; z < n; ++z) {
            for (int x = 0; x < n; ++x) {
                const auto block = static_cast<std::size_t>(chunk.blocks[Chunk::index(x, y, z)]);
                if (rule.shown[block]) occupancy.shown.mark_cell(x, y, z);
                if (rule.hides[block]) occupancy.hides.mark_cell(x, y, z);
            }
        }
    }
    for (const Direction& direction : directions) {
        ivec3 step(0);
        step[direction.axis] = direction.sign;
        const Chunk* neighbour = volume.chunk(key + step);
        if (neighbour == nullptr) continue;
        const int slice = direction.sign > 0 ? 0 : n - 1;
        for (int up = 0; up < n; ++up) {
            for (int right = 0; right < n; ++right) {
                const Block block = neighbour->blocks[cell_index(direction, slice, right, up)];
                if (rule.hides[static_cast<std::size_t>(block)]) occupancy.hides.mark(direction.axis, right, up, direction.sign > 0 ? n + 1 : 0);
            }
        }
    }
}

struct Rectangle {
    int right, up, width, height;
};

void append_quad(MeshData& mesh, const Direction& direction, int slice, Rectangle area, Block block,
                 float size) {
    // An axis that runs against the picture's is walked backwards, so that both start at the quad's lower
    // left corner.
    const auto span = [](int low, int length, int sign) {
        const float first = static_cast<float>(sign > 0 ? low : -(low + length)) - quad_overlap;
        return vec2(first, first + static_cast<float>(length) + 2.0f * quad_overlap);
    };
    const vec2 u = span(area.right, area.width, direction.right_sign);
    const vec2 v = span(area.up, area.height, direction.up_sign);
    vec3 normal(0.0f);
    normal[direction.axis] = static_cast<float>(direction.sign);

    Vertex vertex;
    vertex.normal = pack_normal(normal);
    vertex.material = material_index(block, direction.face);
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const vec2 corner : {vec2(u[0], v[0]), vec2(u[1], v[0]), vec2(u[1], v[1]), vec2(u[0], v[1])}) {
        vertex.uv = corner;
        vertex.position[direction.axis] = static_cast<float>(slice + (direction.sign > 0 ? 1 : 0)) * size;
        vertex.position[direction.right] = corner.x * static_cast<float>(direction.right_sign) * size;
        vertex.position[direction.up] = corner.y * static_cast<float>(direction.up_sign) * size;
        mesh.vertices.push_back(vertex);
        mesh.bounds.add(vertex.position);
    }
    for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(base + corner);
}

/// One plane of unit faces: bit `right` of rows[up].
using Slice = std::array<std::uint32_t, n>;

/// Cuts the plane into rectangles of one kind of block: each starts at the lowest face left over, grows
/// right, then up.
template <class Emit>
void merge(Slice& rows, const Chunk& chunk, const Direction& direction, int slice, Emit&& emit) {
    const auto block_at = [&](int right, int up) {
        return chunk.blocks[cell_index(direction, slice, right, up)];
    };
    for (int up = 0; up < n; ++up) {
        while (rows[static_cast<std::size_t>(up)] != 0) {
            const std::uint32_t row = rows[static_cast<std::size_t>(up)];
            const int right = std::countr_zero(row);
            const Block kind = block_at(right, up);
            int width = 1;
            while (right + width < n && (row >> (right + width) & 1u) != 0 &&
                   block_at(right + width, up) == kind) {
                ++width;
            }
            const std::uint32_t run = (width == n ? ~0u : (1u << width) - 1) << right;
            const auto continues = [&](int above) {
                if ((rows[static_cast<std::size_t>(above)] & run) != run) return false;
                for (int i = right; i < right + width; ++i) {
                    if (block_at(i, above) != kind) return false;
                }
                return true;
            };
            int height = 1;
            while (up + height < n && continues(up + height)) ++height;
            for (int i = up; i < up + height; ++i) rows[static_cast<std::size_t>(i)] &= ~run;
            emit(Rectangle{right, up, width, height}, kind);
        }
    }
}

/// Adds the faces that the rule shows to a mesh; returns how many unit faces they are.
std::size_t append_faces(MeshData& mesh, const VoxelVolume& volume, ivec3 chunk_key, const Chunk& chunk, const FaceRule& rule) {
    ChunkOccupancy occupancy;
    gather(volume, chunk_key, chunk, rule, occupancy);
    std::size_t faces = 0;
    for (const Direction& direction : directions) {
        const auto first = static_cast<std::uint32_t>(mesh.indices.size());
        float lowest = std::numeric_limits<float>::infinity();
        std::array<Slice, n> slices{};
        const auto axis = static_cast<std::size_t>(direction.axis);
        for (std::size_t line = 0; line < occupancy.shown.lines[axis].size(); ++line) {
            const std::uint64_t hides = occupancy.hides.lines[axis][line];
            const std::uint64_t hidden = direction.sign > 0 ? hides >> 1 : hides << 1;
            auto visible = static_cast<std::uint32_t>((occupancy.shown.lines[axis][line] & ~hidden) >> 1);
            faces += static_cast<std::size_t>(std::popcount(visible));
            for (; visible != 0; visible &= visible - 1) {
                const auto slice = static_cast<std::size_t>(std::countr_zero(visible));
                slices[slice][line / n] |= 1u << (line % n);
            }
        }
        for (int slice = 0; slice < n; ++slice) {
            merge(slices[static_cast<std::size_t>(slice)], chunk, direction, slice,
                  [&](Rectangle area, Block kind) {
                      append_quad(mesh, direction, slice, area, kind, volume.block_size());
                      lowest = std::min(lowest, static_cast<float>(direction.sign) * mesh.vertices.back().position[direction.axis]);
                  });
        }
        const auto count = static_cast<std::uint32_t>(mesh.indices.size()) - first;
        if (count > 0) mesh.facings.push_back({.axis = direction.axis, .sign = static_cast<float>(direction.sign), .first = first, .count = count, .lowest = lowest});
    }
    return faces;
}

}  // namespace

MeshData mesh_chunk(const VoxelVolume& volume, ivec3 chunk_key, MeshStats* stats) {
    static const FaceRule rule = opaque_rule();
    MeshData mesh;
    const Chunk* chunk = volume.chunk(chunk_key);
    if (chunk == nullptr) return mesh;
    const std::size_t visible_faces = append_faces(mesh, volume, chunk_key, *chunk, rule);
    if (stats != nullptr) {
        stats->blocks += chunk->count;
        stats->naive_faces += 6 * std::size_t{chunk->count};
        stats->visible_faces += visible_faces;
        stats->quads += mesh.indices.size() / 6;
        stats->triangles += mesh.indices.size() / 3;
    }
    return mesh;
}

MeshData mesh_water(const VoxelVolume& volume, ivec3 chunk_key) {
    static const FaceRule rule = water_rule();
    MeshData mesh;
    const Chunk* chunk = volume.chunk(chunk_key);
    // Most chunks have none, and are told quickly.
    if (chunk == nullptr || std::ranges::find(chunk->blocks, Block::water) == chunk->blocks.end()) return mesh;
    append_faces(mesh, volume, chunk_key, *chunk, rule);
    return mesh;
}

}  // namespace sl
