// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/components.h"
#include "game/voxel_content.h"

namespace sl {

/// Statistics of one chunk's mesh, kept so that totals follow edits. Whatever has it is a chunk of its parent's content.
struct ChunkMesh {
    MeshStats stats;
};

/// The mesh of a chunk as the mesher gives it.
struct MeshedChunk {
    ivec3 key{0};
    MeshData mesh;
    MeshStats stats;
};

/// Shows a chunk with this mesh: its entity, a child of `owner`, comes, goes or stays as the mesh demands. `changed` is where a
/// chunk that is there already differs from before, in metres from its low corner.
void show_chunk(World& world, Entity owner, MeshedChunk chunk, const Bounds& changed = {});
/// Destroys the entity of a chunk and its mesh, if there is one.
void hide_chunk(World& world, VoxelContent& content, ivec3 key);
/// Destroys an entity that show_chunk made, and its mesh.
void destroy_chunk(World& world, Entity chunk);

}  // namespace sl
