// SPDX-License-Identifier: MIT
#include "game/player/voxel_surroundings.h"

#include "engine/ecs/components/transform.h"
#include "engine/ecs/query.h"
#include "game/streaming/terrain_stream.h"
#include "game/voxel_content.h"

namespace sl {

namespace {

/// Touching is not reaching into, also after rounding; share of a block.
constexpr double touch = 1e-6;

struct PlacedVolume {
    const VoxelVolume* volume;
    const TerrainStream* stream;  ///< null where all that there will be is there
    glm::dmat3 blocks_from_world;
    dvec3 origin;
    dvec3 low, high;  ///< of what there is, in blocks

    bool is_there(ivec3 cell) const { return stream == nullptr || stream->is_loaded(column_of(cell)); }
};

template <class Hits>
bool any_block(const PlacedVolume& placed, const BodyBox& box, Hits&& hits) {
    const dvec3 centre = placed.blocks_from_world * (0.5 * (box.low + box.high) - placed.origin), half = 0.5 * (box.high - box.low);
    dvec3 reach(0.0);
    for (int axis = 0; axis < 3; ++axis) reach += glm::abs(placed.blocks_from_world[axis]) * half[axis];
    // Cut to what there is: a body is thousands of the blocks of something small. NaN is nowhere.
    const dvec3 low = glm::max(glm::floor(centre - reach + touch), placed.low), high = glm::min(glm::ceil(centre + reach - touch), placed.high);
    if (!glm::all(glm::lessThan(low, high))) return false;
    for (int y = static_cast<int>(low.y); y < static_cast<int>(high.y); ++y) {
        for (int z = static_cast<int>(low.z); z < static_cast<int>(high.z); ++z) {
            for (int x = static_cast<int>(low.x); x < static_cast<int>(high.x); ++x) {
                if (hits(placed, ivec3(x, y, z))) return true;
            }
        }
    }
    return false;
}

std::vector<PlacedVolume> placed_volumes(World& world) {
    constexpr dvec3 without_end(1e9);
    std::vector<PlacedVolume> placed;
    for (auto [entity, content, transform] : Query<const VoxelContent, const WorldTransform>(world)) {
        const VoxelVolume& volume = world.resource<VoxelVolumes>().at(content.volume);
        const glm::dmat3 world_from_blocks = glm::dmat3(transform.linear) * double{volume.block_size()};
        // Squashed flat, an entity has no blocks to stand on.
        if (std::abs(glm::determinant(world_from_blocks)) < 1e-18) continue;
        const auto* stream = world.find<TerrainStream>(entity);
        const dvec3 low = stream != nullptr ? -without_end : dvec3(volume.low()), high = stream != nullptr ? without_end : dvec3(volume.high());
        placed.push_back({&volume, stream, glm::inverse(world_from_blocks), transform.origin, low, high});
    }
    return placed;
}

template <class Hits>
bool any(const std::vector<PlacedVolume>& volumes, const BodyBox& box, Hits&& hits) {
    return std::ranges::any_of(volumes, [&](const PlacedVolume& one) { return any_block(one, box, hits); });
}

bool is_solid(const PlacedVolume& placed, ivec3 cell) {
    const Block block = placed.volume->get(cell);
    return !placed.is_there(cell) || (block != Block::air && block != Block::water);
}

bool is_water(const PlacedVolume& placed, ivec3 cell) {
    return placed.volume->get(cell) == Block::water;
}

}  // namespace

Surroundings voxel_surroundings(World& world) {
    const auto placed = placed_volumes(world);
    return {.solid = [placed](const BodyBox& box) { return any(placed, box, is_solid); },
            .water = [placed](const dvec3& point) { return any(placed, {point - 1e-3, point + 1e-3}, is_water); }};
}

bool land_is_there(World& world, const BodyBox& box) {
    return !any(placed_volumes(world), box, [](const PlacedVolume& placed, ivec3 cell) { return !placed.is_there(cell); });
}

}  // namespace sl
