// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/components.h"
#include "game/voxel_content.h"

namespace sl {

/// Statistics of one chunk's mesh, kept so that totals follow edits. Whatever has it is a chunk of its parent's content.
struct ChunkMesh {
    MeshStats stats;
};

/// The meshes of a chunk as the mesher gives them.
struct MeshedChunk {
    ivec3 key{0};
    MeshData mesh, water;
    MeshStats stats;
};
MeshedChunk meshed_chunk(const VoxelVolume& volume, ivec3 key);

/// Shows a chunk with these meshes: its entity, a child of `owner`, comes, goes or stays as they demand. `changed` is where a
/// chunk that is there already differs from before, in metres from its low corner.
void show_chunk(World& world, Entity owner, MeshedChunk chunk, const Bounds& changed = {});
/// Destroys the entity of a chunk and its meshes, if there is one.
void hide_chunk(World& world, VoxelContent& content, ivec3 key);
/// Destroys an entity that show_chunk made, and its meshes.
void destroy_chunk(World& world, Entity chunk);

}  // namespace sl
