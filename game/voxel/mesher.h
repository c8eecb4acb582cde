// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/mesh_data.h"
#include "game/voxel/voxel_volume.h"

namespace sl {

/// How far each quad reaches beyond its edges, in blocks. Greedy quads meet in T-junctions, through which
/// rounding would show pinholes of sky.
inline constexpr float quad_overlap = 1.0f / 512.0f;

/// Counts, summed over calls.
struct MeshStats {
    std::size_t blocks = 0;
    std::size_t naive_faces = 0;    ///< 6 per block
    std::size_t visible_faces = 0;  ///< unit faces between an opaque block and one that is not
    std::size_t quads = 0;          ///< after merging
    std::size_t triangles = 0;
};

/// The visible faces of a chunk's opaque blocks, equal neighbours of one plane merged greedily (Lysenko
/// 2012). Positions are metres from the chunk's low corner; uv is in blocks, so a texture repeats per block,
/// with v up (+y) on sides, and u to the right seen from outside on every face; a top has v towards -z, a
/// bottom towards +z. Vertex.material is material_index. Missing chunks count as air. Empty where the chunk
/// is missing.
MeshData mesh_chunk(const VoxelVolume& volume, ivec3 chunk_key, MeshStats* stats = nullptr);

/// In the same way where a chunk's water ends in air: not at the ground beneath it.
MeshData mesh_water(const VoxelVolume& volume, ivec3 chunk_key);

}  // namespace sl
