// SPDX-License-Identifier: MIT
#include "game/voxel/built_place.h"

#include "game/voxel/landscape.h"

namespace sl {

BuiltPlace::BuiltPlace(VoxelVolume blocks, ivec2 middle, int half)
    : blocks_(std::move(blocks)), middle_(middle), half_(half), low_(blocks_.low().y), high_(blocks_.high().y) {}

int BuiltPlace::distance(ivec2 column) const {
    const ivec2 local = column - middle_;
    const ivec2 out = glm::max(glm::max(-half_ - local, local - (half_ - 1)), 0);
    return std::max(out.x, out.y) + std::min(out.x, out.y) * 3 / 8;
}

int BuiltPlace::rim_height(ivec2 column) const {
    const ivec2 nearest = glm::clamp(column - middle_, -half_, half_ - 1);
    int y = high_ - 1;
    while (y >= low_ && blocks_.get({nearest.x, y, nearest.y}) == Block::air) --y;
    return y + 1;
}

void BuiltPlace::fill_column(VoxelVolume& volume, ivec2 column) const {
    const ivec2 local = column - middle_;
    int lowest = low_;
    while (lowest < high_ && blocks_.get({local.x, lowest, local.y}) == Block::air) ++lowest;
    volume.fill({column.x, landscape::bottom, column.y}, {column.x + 1, lowest, column.y + 1}, Block::stone);
    for (int y = lowest; y < high_; ++y) volume.set({column.x, y, column.y}, blocks_.get({local.x, y, local.y}));
}

}  // namespace sl
