// SPDX-License-Identifier: MIT
#include "game/player/voxel_surroundings.h"

#include "engine/ecs/components/transform.h"
#include "engine/ecs/query.h"
#include "game/voxel_content.h"

namespace sl {

namespace {

/// Touching is not reaching into, also after rounding; share of a block.
constexpr double touch = 1e-6;

struct PlacedVolume {
    const VoxelVolume* volume;
    glm::dmat3 blocks_from_world;
    dvec3 origin;
    dvec3 low, high;  ///< of what there is, in blocks
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
                if (hits(placed.volume->get({x, y, z}))) return true;
            }
        }
    }
    return false;
}

}  // namespace

Surroundings voxel_surroundings(World& world) {
    std::vector<PlacedVolume> placed;
    for (auto [entity, content, transform] : Query<const VoxelContent, const WorldTransform>(world)) {
        const VoxelVolume& volume = world.resource<VoxelVolumes>().at(content.volume);
        const glm::dmat3 world_from_blocks = glm::dmat3(transform.linear) * double{volume.block_size()};
        // Squashed flat, an entity has no blocks to stand on.
        if (std::abs(glm::determinant(world_from_blocks)) < 1e-18) continue;
        placed.push_back({&volume, glm::inverse(world_from_blocks), transform.origin, dvec3(volume.low()), dvec3(volume.high())});
    }
    const auto any = [](const std::vector<PlacedVolume>& volumes, const BodyBox& box, auto&& hits) {
        return std::ranges::any_of(volumes, [&](const PlacedVolume& one) { return any_block(one, box, hits); });
    };
    return {.solid = [placed, any](const BodyBox& box) { return any(placed, box, [](Block block) { return block != Block::air && block != Block::water; }); },
            .water = [placed, any](const dvec3& point) { return any(placed, {point - 1e-3, point + 1e-3}, [](Block block) { return block == Block::water; }); }};
}

}  // namespace sl
