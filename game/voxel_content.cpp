// SPDX-License-Identifier: MIT
#include "game/voxel_content.h"

#include <set>

#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/ecs/components.h"
#include "engine/ecs/parent.h"
#include "engine/ecs/query.h"
#include "game/camera_in_water.h"
#include "game/streaming/terrain_stream.h"
#include "game/voxel/block_textures.h"
#include "game/voxel/generators.h"
#include "game/voxel/raycast.h"
#include "game/voxel_chunks.h"

namespace sl {

namespace {

MaterialTable block_material_table() {
    MaterialTable table;
    for (const BlockMaterial& block : block_materials()) {
        Material material;
        material.base_colour = vec3(1.0f);  // the texture carries the colour
        material.roughness = block.roughness;
        material.metallic = block.metallic;
        // Blocks are matte unless they are metal: their light is then purely diffuse, as an RSM takes it to be.
        material.specular = 0.0f;
        material.emission = block.emissive_nit;
        table.entries.push_back({material, static_cast<std::int32_t>(block.texture_layer)});
    }
    return table;
}

TextureLayers block_texture_layers() {
    TextureLayers result{.size = 16, .mips = block_texture_levels, .layers = {}, .version = 1};
    for (const BlockTexture& texture : make_block_textures(1)) {
        auto& bytes = result.layers.emplace_back();
        for (const auto& mip : texture.mips) bytes.insert(bytes.end(), mip.begin(), mip.end());
    }
    return result;
}

void drop_content(World& world, VoxelContent& content) {
    for (const auto& [key, chunk] : content.chunks) destroy_chunk(world, chunk);
    world.resource<VoxelVolumes>().erase(content.volume);
}

void make_content(World& world, Entity entity, const VoxelGenerator& generator) {
    auto* old = world.find<VoxelContent>(entity);
    VoxelVolume volume(generator.block_size);
    const GeneratorSettings settings{.seed = generator.seed, .size = ivec3(generator.width, generator.height, generator.depth), .blocks = generator.blocks};
    try {
        generate(volume, generator_names()[generator.generator], settings);
    } catch (const Error& error) {
        if (old == nullptr) throw;
        // Somebody edits it: what was there stays until it is right.
        log::error("{}", error.what());
        old->made_by = generator;
        return;
    }
    if (old != nullptr) drop_content(world, *old);
    world.add(entity, VoxelContent{.volume = world.resource<VoxelVolumes>().insert(std::move(volume)), .made_by = generator});
}

void mesh_changed_chunk(World& world, Entity owner, const VoxelVolume& volume, ivec3 key) {
    // A hair more than the blocks: faces of those beside them lie in their sides.
    const float block = volume.block_size();
    const VoxelVolume::Box box = volume.changed_box(key);
    const vec3 low = vec3(box.low - chunk_low(key)) * block, high = vec3(box.high - chunk_low(key)) * block;
    show_chunk(world, owner, meshed_chunk(volume, key), Bounds{low, high}.grown(0.01f * block));
}

/// An entity that lost its generator, or was destroyed, leaves chunks and a volume behind.
void drop_orphans(World& world) {
    std::vector<Entity> orphans;
    for (auto [entity, chunk, parent] : Query<const ChunkMesh, const Parent>(world)) {
        if (!world.alive(parent.entity) || !world.has<VoxelGenerator>(parent.entity)) orphans.push_back(entity);
    }
    for (const Entity orphan : orphans) destroy_chunk(world, orphan);

    std::vector<Entity> emptied;
    std::set<Handle<VoxelVolume>> held;
    for (auto [entity, content] : Query<const VoxelContent>(world)) {
        world.has<VoxelGenerator>(entity) ? void(held.insert(content.volume)) : emptied.push_back(entity);
    }
    for (const Entity entity : emptied) world.remove<VoxelContent>(entity);
    auto& volumes = world.resource<VoxelVolumes>();
    if (volumes.size() == held.size()) return;
    std::vector<Handle<VoxelVolume>> unheld;
    volumes.each([&](Handle<VoxelVolume> handle, const VoxelVolume&) {
        if (!held.contains(handle)) unheld.push_back(handle);
    });
    for (const auto handle : unheld) volumes.erase(handle);
}

void count_stats(World& world, std::size_t remeshed) {
    VoxelStats stats;
    stats.remeshed = remeshed;
    for (auto [entity, chunk] : Query<const ChunkMesh>(world)) {
        ++stats.chunks;
        stats.total.blocks += chunk.stats.blocks;
        stats.total.naive_faces += chunk.stats.naive_faces;
        stats.total.visible_faces += chunk.stats.visible_faces;
        stats.total.quads += chunk.stats.quads;
        stats.total.triangles += chunk.stats.triangles;
    }
    world.resource<VoxelStats>() = stats;
}

}  // namespace

void visit_fields(FieldVisitor& visit, VoxelGenerator& generator) {
    visit.choice("generator", generator.generator, generator_names(), {.help = "What fills the blocks."});
    visit.field("seed", generator.seed, {.help = "Another seed, another world of the same kind."});
    visit.field("block_size", generator.block_size,
                {.min = 1e-4, .max = 1e3, .unit = "m", .help = "Edge of a block.", .look = FieldLook::logarithmic});
    const FieldInfo extent{.min = 1, .max = 256, .unit = "blocks", .help = "Extent, for generators that have one (rooms, terrain)."};
    visit.field("width", generator.width, extent);
    visit.field("height", generator.height, extent);
    visit.field("depth", generator.depth, extent);
    visit.field("blocks", generator.blocks, {.help = "The blocks of the generator \"region\", as `secondlight export` writes them."});
}

void voxel_content(World& world) {
    std::vector<std::pair<Entity, VoxelGenerator>> missing;
    for (auto [entity, generator] : Query<const VoxelGenerator>(world)) {
        const auto* content = world.find<VoxelContent>(entity);
        if (content == nullptr || !(content->made_by == generator)) missing.emplace_back(entity, generator);
    }
    for (const auto& [entity, generator] : missing) make_content(world, entity, generator);

    std::size_t remeshed = 0;
    std::vector<Entity> owners;
    for (auto [entity, content] : Query<const VoxelContent>(world)) owners.push_back(entity);
    for (const Entity owner : owners) {
        VoxelVolume& volume = world.resource<VoxelVolumes>().at(world.get<VoxelContent>(owner).volume);
        for (const ivec3 key : volume.take_changed_chunks()) {
            mesh_changed_chunk(world, owner, volume, key);
            ++remeshed;
        }
    }
    drop_orphans(world);
    count_stats(world, remeshed);
}

void add_voxel_world(App& app) {
    app.registry().add<VoxelGenerator>("voxels");
    app.world.add_resource(VoxelVolumes{});
    app.world.add_resource(VoxelStats{});
    app.world.add_resource(block_material_table());
    app.world.add_resource(block_texture_layers());
    app.schedule.add(Stage::simulate, "voxel_content", &voxel_content);
    app.schedule.add(Stage::mesh, "camera_in_water", &camera_in_water);
}

std::optional<BlockPick> pick_block(World& world, const dvec3& origin, vec3 direction, float max_distance) {
    std::optional<BlockPick> nearest;
    float reach = max_distance;
    for (auto [entity, content, transform] : Query<const VoxelContent, const WorldTransform>(world)) {
        const mat3 local_from_world = glm::inverse(transform.linear);
        const vec3 local_origin = local_from_world * vec3(origin - transform.origin);
        const vec3 local_direction = local_from_world * direction;
        const float scale = glm::length(local_direction) / glm::length(direction);
        if (!(scale > 0.0f) || !std::isfinite(scale)) continue;
        const auto hit = raycast(world.resource<VoxelVolumes>().at(content.volume), local_origin, local_direction, reach * scale, Block::water);
        if (!hit) continue;
        reach = hit->distance / scale;
        nearest = BlockPick{entity, hit->cell, hit->normal};
    }
    return nearest;
}

void put_block(World& world, Entity entity, ivec3 cell, Block block) {
    const auto* content = world.find<VoxelContent>(entity);
    if (content == nullptr) return;
    if (auto* stream = world.find<TerrainStream>(entity)) {
        stream->keep(cell, block);
        if (!stream->is_loaded(column_of(cell))) return;
    }
    world.resource<VoxelVolumes>().at(content->volume).set(cell, block);
}

void set_block(World& world, Entity entity, ivec3 cell, Block block) {
    if (!world.has<VoxelContent>(entity)) return;
    put_block(world, entity, cell, block);
    if (auto* journal = world.find_resource<EditJournal>()) journal->edits.push_back({entity, cell, block});
}

}  // namespace sl
