// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "engine/core/fields.h"
#include "engine/core/slot_map.h"
#include "engine/ecs/app.h"
#include "game/voxel/mesher.h"

namespace sl {

/// Fills an entity with blocks made by a named generator. In scene files: "voxels".
struct VoxelGenerator {
    std::size_t generator = 0;  ///< index into generator_names()
    std::uint32_t seed = 1;
    float block_size = 0.5f;
    std::uint32_t width = 8, height = 6, depth = 8;
    std::string blocks{};  ///< as region_text writes them

    bool operator==(const VoxelGenerator&) const = default;
};
void visit_fields(FieldVisitor& visit, VoxelGenerator& generator);

using VoxelVolumes = SlotMap<VoxelVolume>;

/// The blocks of an entity, made by the system voxel_content from its VoxelGenerator; edit the volume and its chunks are
/// meshed again.
struct VoxelContent {
    Handle<VoxelVolume> volume;
    VoxelGenerator made_by;
    std::map<std::array<int, 3>, Entity> chunks;
};

/// What blocks were set by `set_block` and nobody has saved yet; a resource of games that save.
struct EditJournal {
    struct Edit {
        Entity entity;
        ivec3 cell;
        Block block;
    };
    std::vector<Edit> edits;
};

/// What all voxel meshes of the world add up to; a resource.
struct VoxelStats {
    MeshStats total;                 ///< of what is meshed now
    std::size_t chunks = 0;
    std::size_t remeshed = 0;        ///< chunks meshed in the last frame
};

/// Generates missing content and meshes changed chunks: one entity per chunk, child of the content's entity.
void voxel_content(World& world);

/// The voxel world as a plugin: block materials and textures, the component "voxels", the systems.
void add_voxel_world(App& app);

/// The block that a ray meets first in any voxel entity, in world space; water does not stop it.
struct BlockPick {
    Entity entity;
    ivec3 cell{0};
    ivec3 normal{0};
};
std::optional<BlockPick> pick_block(World& world, const dvec3& origin, vec3 direction, float max_distance);
/// Sets a block of a voxel entity; its chunk is meshed again at the next frame. Where land is not loaded, it will be there when
/// the land is.
void put_block(World& world, Entity entity, ivec3 cell, Block block);
/// The same, and the journal tells of it, so that games save it.
void set_block(World& world, Entity entity, ivec3 cell, Block block);

}  // namespace sl
