// SPDX-License-Identifier: MIT
#include "engine/core/error.h"
#include "game/voxel/generators.h"

namespace sl {

void generate_room(VoxelVolume& volume, ivec3 size, RoomKind kind) {
    if (glm::any(glm::lessThan(size, ivec3(1)))) {
        fail("a room of {} x {} x {} blocks: give at least 1 each way", size.x, size.y, size.z);
    }
    volume.fill(ivec3(-1), size + 1, Block::white_wool);
    if (kind == RoomKind::cornell) {
        volume.fill({-1, 0, 0}, {0, size.y, size.z}, Block::red_wool);
        volume.fill({size.x, 0, 0}, {size.x + 1, size.y, size.z}, Block::green_wool);
    }
    volume.fill(ivec3(0), size, Block::air);
    if (kind == RoomKind::cornell) volume.fill({-1, -1, size.z}, size + 1, Block::air);
    if (kind == RoomKind::skylight) {
        const ivec3 hole = glm::max(size / 3, 1);
        const ivec3 low = (size - hole) / 2;
        volume.fill({low.x, size.y, low.z}, {low.x + hole.x, size.y + 1, low.z + hole.z}, Block::air);
    }
}

}  // namespace sl
