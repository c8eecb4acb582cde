// SPDX-License-Identifier: MIT
#include "game/voxel/terrain.h"

#include <algorithm>

#include "engine/core/error.h"
#include "game/voxel/generators.h"
#include "game/voxel/lattice_noise.h"

namespace sl {
namespace {

/// Soil gets thin on the hills, so that their steps show rock.
int dirt_depth(ivec2 column, int height, std::uint32_t seed) {
    return height <= 2 ? 2 : 2 - value_noise(seed + 1, column.x, column.y, 8, 8) / 400;
}

Block top_block(ivec2 column, int height, std::uint32_t seed) {
    if (height <= 0) return Block::grass;
    const int patch = value_noise(seed, column.x, column.y, 6, 6);
    if (height + (patch - 512) / 128 >= 20) return Block::snow;
    if (height > 3 && patch > 700) return patch > 860 ? Block::cobblestone : Block::stone;
    if (patch < 200) return Block::dirt;
    return Block::grass;
}

}  // namespace

void fill_ground_column(VoxelVolume& volume, ivec2 column, int bottom, int height, std::uint32_t seed) {
    const auto fill = [&](int low, int high, Block kind) {
        volume.fill({column.x, std::max(low, bottom), column.y}, {column.x + 1, high, column.y + 1}, kind);
    };
    const Block top = top_block(column, height, seed);
    const bool rock = top == Block::stone || top == Block::cobblestone;
    fill(bottom, height, Block::stone);
    if (!rock)
        fill(std::max(height - 1 - dirt_depth(column, height, seed), bottom + 1), height - 1, Block::dirt);
    fill(height - 1, height, top);
}

void generate_terrain(VoxelVolume& volume, const GeneratorSettings& settings) {
    if (settings.size.x < 1 || settings.size.z < 1) {
        fail("a terrain of {} x {} blocks: give at least 1 each way", settings.size.x, settings.size.z);
    }
    const std::uint32_t seed = settings.seed;
    const ivec3 low = -settings.size / 2;
    for (int z = low.z; z < low.z + settings.size.z; ++z) {
        for (int x = low.x; x < low.x + settings.size.x; ++x) {
            const int hills = value_noise(seed, x, z, 48, 48) + value_noise(seed + 1, x, z, 20, 20) / 2;
            const int height = std::max(0, (hills - 500) / 40 + value_noise(seed + 2, x, z, 7, 7) / 300);
            fill_ground_column(volume, {x, z}, -4, height, seed + 3);
        }
    }
}

}  // namespace sl
