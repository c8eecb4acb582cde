// SPDX-License-Identifier: MIT
#include "game/voxel/generators.h"

namespace sl {

// A fox, built around x = 0 and z = 0, on y = 0, looking along +x.
void generate_creature(VoxelVolume& volume) {
    const auto box = [&volume](ivec3 low, ivec3 high, Block kind) { volume.fill(low, high, kind); };
    /// The same on both sides of the animal's middle plane; z counts outward.
    const auto pair = [&box](ivec3 low, ivec3 high, Block kind) {
        box(low, high, kind);
        box({low.x, low.y, -high.z}, {high.x, high.y, -low.z}, kind);
    };
    for (const int x : {-6, 3}) {
        pair({x, 2, 2}, {x + 2, 5, 4}, Block::orange_wool);
        pair({x, 0, 2}, {x + 2, 2, 4}, Block::black_wool);
    }
    box({-7, 4, -4}, {6, 10, 4}, Block::orange_wool);
    box({-5, 4, -3}, {6, 5, 3}, Block::white_wool);
    box({5, 5, -2}, {6, 8, 2}, Block::white_wool);

    box({3, 7, -4}, {8, 14, 4}, Block::orange_wool);
    pair({6, 8, 3}, {8, 10, 5}, Block::white_wool);
    box({8, 7, -2}, {10, 10, 2}, Block::orange_wool);
    box({7, 7, -3}, {10, 9, 3}, Block::white_wool);
    box({8, 8, -2}, {10, 9, 2}, Block::orange_wool);
    box({9, 9, -1}, {10, 10, 1}, Block::black_wool);
    pair({7, 11, 2}, {8, 13, 3}, Block::black_wool);
    pair({4, 14, 2}, {6, 16, 4}, Block::orange_wool);
    pair({4, 15, 3}, {6, 16, 4}, Block::black_wool);
    pair({5, 14, 2}, {6, 15, 3}, Block::white_wool);

    box({-9, 8, -2}, {-7, 11, 2}, Block::orange_wool);
    box({-10, 10, -2}, {-8, 13, 2}, Block::orange_wool);
    box({-10, 12, -1}, {-8, 14, 1}, Block::white_wool);
}

}  // namespace sl
