// SPDX-License-Identifier: MIT
#include "game/voxel_chunks.h"

#include "engine/ecs/parent.h"

namespace sl {

namespace {

std::array<int, 3> map_key(ivec3 key) {
    return {key.x, key.y, key.z};
}

}  // namespace

void show_chunk(World& world, Entity owner, MeshedChunk chunk, const Bounds& changed) {
    auto& content = world.get<VoxelContent>(owner);
    if (chunk.mesh.indices.empty()) return hide_chunk(world, content, chunk.key);
    auto& pool = world.resource<MeshPool>();
    const auto found = content.chunks.find(map_key(chunk.key));
    if (found == content.chunks.end()) {
        const float block_size = world.resource<VoxelVolumes>().at(content.volume).block_size();
        const Transform place{.translation = dvec3(chunk_low(chunk.key)) * double{block_size}};
        const MeshInstance instance{pool.insert(std::move(chunk.mesh)), 0};
        content.chunks[map_key(chunk.key)] = world.create(place, Parent{owner}, instance, ChunkMesh{chunk.stats});
        return;
    }
    MeshData& old = pool.at(world.get<MeshInstance>(found->second).mesh);
    chunk.mesh.version = old.version + 1;
    chunk.mesh.changed = changed;
    old = std::move(chunk.mesh);
    world.get<ChunkMesh>(found->second) = {chunk.stats};
}

void hide_chunk(World& world, VoxelContent& content, ivec3 key) {
    const auto found = content.chunks.find(map_key(key));
    if (found == content.chunks.end()) return;
    destroy_chunk(world, found->second);
    content.chunks.erase(found);
}

void destroy_chunk(World& world, Entity chunk) {
    if (const auto* mesh = world.find<MeshInstance>(chunk)) world.resource<MeshPool>().erase(mesh->mesh);
    world.destroy(chunk);
}

}  // namespace sl
