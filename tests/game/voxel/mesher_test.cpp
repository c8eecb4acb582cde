// SPDX-License-Identifier: MIT
#include "game/voxel/mesher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "game/voxel/generators.h"
#include "game/voxel/lattice_noise.h"

namespace sl {
namespace {

/// One side of one block: cell, axis, sign of the outward normal.
using UnitFace = std::tuple<int, int, int, int, int>;
struct FaceUse {
    int count = 0;
    std::uint32_t material = 0;
};
using FaceMap = std::map<UnitFace, FaceUse>;

BlockFace face_kind(int axis, int sign) {
    return axis != 1 ? BlockFace::side : sign > 0 ? BlockFace::top : BlockFace::bottom;
}

FaceMap brute_force_faces(const VoxelVolume& volume) {
    FaceMap faces;
    const ivec3 low = volume.low();
    const ivec3 high = volume.high();
    for (int y = low.y; y < high.y; ++y) {
        for (int z = low.z; z < high.z; ++z) {
            for (int x = low.x; x < high.x; ++x) {
                const Block block = volume.get({x, y, z});
                if (!block_info(block).opaque) continue;
                for (int axis = 0; axis < 3; ++axis) {
                    for (const int sign : {-1, 1}) {
                        ivec3 next(x, y, z);
                        next[axis] += sign;
                        if (block_info(volume.get(next)).opaque) continue;
                        faces[{x, y, z, axis, sign}] = {1, material_index(block, face_kind(axis, sign))};
                    }
                }
            }
        }
    }
    return faces;
}

/// Takes a quad apart into unit faces, and checks its winding and its texture coordinates on the way.
void add_quad(FaceMap& faces, const Vertex* quad, ivec3 origin, float size) {
    const vec3 normal = glm::round(unpack_normal(quad[0].normal));
    const vec3 right = quad[1].position - quad[0].position;
    const vec3 up = quad[3].position - quad[0].position;
    EXPECT_GT(glm::dot(glm::cross(right, up), normal), 0.0f) << "wound away from its normal";
    EXPECT_NEAR(glm::length(right), (quad[1].uv.x - quad[0].uv.x) * size, 1e-4f);
    EXPECT_NEAR(glm::length(up), (quad[3].uv.y - quad[0].uv.y) * size, 1e-4f);
    const int axis = normal.x != 0.0f ? 0 : normal.y != 0.0f ? 1 : 2;
    const int sign = normal[axis] > 0.0f ? 1 : -1;
    vec3 low = quad[0].position;
    vec3 high = low;
    for (int corner = 0; corner < 4; ++corner) {
        const Vertex& vertex = quad[corner];
        low = glm::min(low, vertex.position);
        high = glm::max(high, vertex.position);
        EXPECT_EQ(vertex.normal, quad[0].normal);
        EXPECT_EQ(vertex.material, quad[0].material);
        if (axis != 1) {
            EXPECT_NEAR(vertex.uv.y, vertex.position.y / size, 1e-4f) << "a side's picture stands upright";
        }
    }
    ivec3 first(0);
    ivec3 last(0);
    for (int i = 0; i < 3; ++i) {
        const float overlap = i == axis ? 0.0f : quad_overlap;
        const float exact_low = low[i] / size + overlap;
        const float exact_high = high[i] / size - overlap;
        EXPECT_NEAR(exact_low, std::round(exact_low), 1e-3f);
        EXPECT_NEAR(exact_high, std::round(exact_high), 1e-3f);
        first[i] = static_cast<int>(std::lround(exact_low));
        last[i] = static_cast<int>(std::lround(exact_high));
    }
    first[axis] -= sign > 0 ? 1 : 0;
    last[axis] = first[axis] + 1;
    for (int y = first.y; y < last.y; ++y) {
        for (int z = first.z; z < last.z; ++z) {
            for (int x = first.x; x < last.x; ++x) {
                FaceUse& use = faces[{x + origin.x, y + origin.y, z + origin.z, axis, sign}];
                ++use.count;
                use.material = quad[0].material;
            }
        }
    }
}

FaceMap meshed_faces(const VoxelVolume& volume, MeshStats& stats) {
    FaceMap faces;
    for (const ivec3 key : volume.chunk_keys()) {
        const MeshData mesh = mesh_chunk(volume, key, &stats);
        EXPECT_EQ(mesh.vertices.size() % 4, 0u);
        EXPECT_EQ(mesh.indices.size(), mesh.vertices.size() / 4 * 6);
        for (std::uint32_t base = 0; base < mesh.vertices.size(); base += 4) {
            add_quad(faces, &mesh.vertices[base], chunk_low(key), volume.block_size());
            const std::uint32_t* index = &mesh.indices[base / 4 * 6];
            const std::array expected{base, base + 1, base + 2, base, base + 2, base + 3};
            EXPECT_TRUE(std::equal(expected.begin(), expected.end(), index));
        }
    }
    return faces;
}

void expect_exact_cover(const VoxelVolume& volume) {
    MeshStats stats;
    const FaceMap meshed = meshed_faces(volume, stats);
    const FaceMap expected = brute_force_faces(volume);
    EXPECT_EQ(meshed.size(), expected.size());
    EXPECT_EQ(stats.visible_faces, expected.size());
    EXPECT_EQ(stats.blocks, volume.block_count());
    EXPECT_EQ(stats.naive_faces, 6 * volume.block_count());
    EXPECT_EQ(stats.triangles, 2 * stats.quads);
    EXPECT_LE(stats.quads, stats.visible_faces);
    std::size_t wrong = 0;
    for (const auto& [face, use] : expected) {
        const auto found = meshed.find(face);
        wrong += found == meshed.end() || found->second.count != 1 || found->second.material != use.material;
    }
    EXPECT_EQ(wrong, 0u);
}

VoxelVolume random_volume(std::uint32_t seed, ivec3 low, ivec3 high, int share, int kinds) {
    VoxelVolume volume(0.25f);
    for (int y = low.y; y < high.y; ++y) {
        for (int z = low.z; z < high.z; ++z) {
            for (int x = low.x; x < high.x; ++x) {
                const auto layer = seed * 1000 + static_cast<std::uint32_t>(y - low.y);
                if (lattice_pick(layer, x, z, 1024) >= share) continue;
                volume.set({x, y, z}, static_cast<Block>(1 + lattice_pick(layer + 500, x, z, kinds)));
            }
        }
    }
    return volume;
}

MeshStats stats_of(const VoxelVolume& volume) {
    MeshStats stats;
    for (const ivec3 key : volume.chunk_keys()) mesh_chunk(volume, key, &stats);
    return stats;
}

TEST(Mesher, AMissingChunkIsEmpty) {
    EXPECT_TRUE(mesh_chunk(VoxelVolume(), {0, 0, 0}).indices.empty());
    EXPECT_TRUE(mesh_chunk(VoxelVolume(), {0, 0, 0}).bounds.empty());
}

TEST(Mesher, ASingleBlockHasSixQuads) {
    VoxelVolume volume(0.5f);
    volume.set({33, 2, 3}, Block::grass);
    const MeshData mesh = mesh_chunk(volume, {1, 0, 0});
    EXPECT_EQ(mesh.vertices.size(), 24u);
    EXPECT_EQ(mesh.indices.size(), 36u);
    const float beyond = quad_overlap * 0.5f;
    EXPECT_NEAR(glm::distance(mesh.bounds.low, vec3(0.5f, 1.0f, 1.5f) - beyond), 0.0f, 1e-5f);
    EXPECT_NEAR(glm::distance(mesh.bounds.high, vec3(1.0f, 1.5f, 2.0f) + beyond), 0.0f, 1e-5f);
    std::map<std::uint32_t, int> uses;
    for (const Vertex& vertex : mesh.vertices) ++uses[vertex.material];
    EXPECT_EQ(uses[material_index(Block::grass, BlockFace::top)], 4);
    EXPECT_EQ(uses[material_index(Block::grass, BlockFace::bottom)], 4);
    EXPECT_EQ(uses[material_index(Block::grass, BlockFace::side)], 16);
}

TEST(Mesher, EqualNeighboursMerge) {
    VoxelVolume volume;
    volume.fill({0, 0, 0}, {2, 1, 1}, Block::stone);
    EXPECT_EQ(stats_of(volume).quads, 6u);
    EXPECT_EQ(stats_of(volume).visible_faces, 10u);
    volume.set({1, 0, 0}, Block::dirt);
    EXPECT_EQ(stats_of(volume).quads, 10u)
        << "another kind does not merge, and the face between stays hidden";
    volume.fill({0, 0, 0}, {32, 32, 32}, Block::stone);
    EXPECT_EQ(stats_of(volume).triangles, 12u);
}

TEST(Mesher, FacesBetweenChunksAreHidden) {
    VoxelVolume volume;
    volume.fill({-32, 0, 0}, {32, 32, 32}, Block::stone);
    EXPECT_EQ(stats_of(volume).quads, 10u);
    expect_exact_cover(volume);
}

TEST(Mesher, RandomVolumesAreCoveredExactlyOnce) {
    for (const int share : {60, 512, 960}) {
        expect_exact_cover(random_volume(1, {-5, 25, -36}, {7, 40, 4}, share, 3));
        expect_exact_cover(random_volume(2, {20, -6, 27}, {40, 9, 36}, share, 1));
    }
}

TEST(Mesher, AWorldIsCoveredExactlyOnce) {
    VoxelVolume volume;
    generate(volume, "paper_world", {.seed = 3});
    expect_exact_cover(volume);
}

TEST(Mesher, WaterHasAMeshOfItsOwnThatEndsAtTheGround) {
    VoxelVolume volume;
    volume.fill({0, 0, 0}, {4, 1, 4}, Block::stone);
    volume.fill({0, 1, 0}, {4, 3, 4}, Block::water);
    MeshStats stats;
    mesh_chunk(volume, {0, 0, 0}, &stats);
    EXPECT_EQ(stats.quads, 6u) << "the ground is seen through it";
    const MeshData water = mesh_water(volume, {0, 0, 0});
    EXPECT_EQ(water.indices.size() / 6, 5u) << "four sides and a top";
    for (const Vertex& vertex : water.vertices) EXPECT_GE(unpack_normal(vertex.normal).y, -0.1f);
    volume.fill({0, 1, 0}, {4, 3, 4}, Block::air);
    EXPECT_TRUE(mesh_water(volume, {0, 0, 0}).indices.empty());
}

TEST(Mesher, WaterEndsNotWhereItGoesOnInTheNextChunk) {
    VoxelVolume volume;
    volume.fill({-32, 0, 0}, {32, 1, 32}, Block::water);
    EXPECT_EQ(mesh_water(volume, {0, 0, 0}).indices.size() / 6 + mesh_water(volume, {-1, 0, 0}).indices.size() / 6, 10u);
}

TEST(Mesher, PicturesAreNotMirrored) {
    VoxelVolume volume(1.0f);
    volume.set({0, 0, 0}, Block::stone);
    const MeshData mesh = mesh_chunk(volume, {0, 0, 0});
    for (std::size_t base = 0; base < mesh.vertices.size(); base += 4) {
        const vec3 normal = glm::round(unpack_normal(mesh.vertices[base].normal));
        const vec3 u_axis = glm::normalize(mesh.vertices[base + 1].position - mesh.vertices[base].position);
        const vec3 v_axis = glm::normalize(mesh.vertices[base + 3].position - mesh.vertices[base].position);
        EXPECT_NEAR(glm::distance(glm::cross(u_axis, v_axis), normal), 0.0f, 1e-5f);
        EXPECT_GT(mesh.vertices[base + 1].uv.x, mesh.vertices[base].uv.x);
        EXPECT_GT(mesh.vertices[base + 3].uv.y, mesh.vertices[base].uv.y);
    }
}

}  // namespace
}  // namespace sl
