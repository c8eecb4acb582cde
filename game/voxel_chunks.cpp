// SPDX-License-Identifier: MIT
#include "game/voxel_chunks.h"

#include "engine/ecs/components/water.h"
#include "engine/ecs/parent.h"

namespace sl {

namespace {

std::array<int, 3> map_key(ivec3 key) {
    return {key.x, key.y, key.z};
}

void replace(MeshData& old, MeshData mesh, const Bounds& changed) {
    mesh.version = old.version + 1;
    mesh.changed = changed;
    old = std::move(mesh);
}

void show_water(World& world, Entity chunk, MeshData water) {
    auto& pool = world.resource<MeshPool>();
    auto* surface = world.find<WaterSurface>(chunk);
    if (surface != nullptr && water.indices.empty()) {
        pool.erase(surface->mesh);
        world.remove<WaterSurface>(chunk);
    } else if (surface != nullptr) {
        replace(pool.at(surface->mesh), std::move(water), {});
    } else if (!water.indices.empty()) {
        world.add(chunk, WaterSurface{pool.insert(std::move(water))});
    }
}

}  // namespace

MeshedChunk meshed_chunk(const VoxelVolume& volume, ivec3 key) {
    MeshedChunk chunk{.key = key, .mesh = {}, .water = mesh_water(volume, key), .stats = {}};
    chunk.mesh = mesh_chunk(volume, key, &chunk.stats);
    return chunk;
}

void show_chunk(World& world, Entity owner, MeshedChunk chunk, const Bounds& changed) {
    auto& content = world.get<VoxelContent>(owner);
    if (chunk.mesh.indices.empty() && chunk.water.indices.empty()) return hide_chunk(world, content, chunk.key);
    auto& pool = world.resource<MeshPool>();
    const auto found = content.chunks.find(map_key(chunk.key));
    if (found == content.chunks.end()) {
        const float block_size = world.resource<VoxelVolumes>().at(content.volume).block_size();
        const Transform place{.translation = dvec3(chunk_low(chunk.key)) * double{block_size}};
        const MeshInstance instance{pool.insert(std::move(chunk.mesh)), 0};
        const Entity shown = content.chunks[map_key(chunk.key)] = world.create(place, Parent{owner}, instance, ChunkMesh{chunk.stats});
        return show_water(world, shown, std::move(chunk.water));
    }
    replace(pool.at(world.get<MeshInstance>(found->second).mesh), std::move(chunk.mesh), changed);
    world.get<ChunkMesh>(found->second) = {chunk.stats};
    show_water(world, found->second, std::move(chunk.water));
}

void hide_chunk(World& world, VoxelContent& content, ivec3 key) {
    const auto found = content.chunks.find(map_key(key));
    if (found == content.chunks.end()) return;
    destroy_chunk(world, found->second);
    content.chunks.erase(found);
}

void destroy_chunk(World& world, Entity chunk) {
    if (const auto* mesh = world.find<MeshInstance>(chunk)) world.resource<MeshPool>().erase(mesh->mesh);
    if (const auto* water = world.find<WaterSurface>(chunk)) world.resource<MeshPool>().erase(water->mesh);
    world.destroy(chunk);
}

}  // namespace sl
