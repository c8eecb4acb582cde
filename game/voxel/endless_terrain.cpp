// SPDX-License-Identifier: MIT
#include "game/voxel/endless_terrain.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "game/voxel/cave_line.h"
#include "game/voxel/crystal_valley.h"
#include "game/voxel/forest.h"
#include "game/voxel/generators.h"
#include "game/voxel/landscape.h"
#include "game/voxel/paper_world.h"

namespace sl {
namespace {

constexpr int blend_width = 48;  ///< blocks over which the land rises or falls to a place's rim
constexpr int no_caves = 8;      ///< blocks round a place
constexpr int tree_line = 46;
// Each noise has seeds of its own.
constexpr std::uint32_t cave_seed = 100, forest_seed = 200;

template <class Generate>
VoxelVolume built(Generate generate, std::uint32_t seed) {
    VoxelVolume blocks;
    generate(blocks, seed);
    return blocks;
}

/// From `from` at 0 to `to` at blend_width, level at both ends.
int blended(int from, int to, int distance) {
    const int t = distance * 256 / blend_width;
    const int smooth = t * t * (3 * 256 - 2 * t) / (256 * 256);
    return from + (to - from) * smooth / 256;
}

}  // namespace

EndlessTerrain::EndlessTerrain(std::uint32_t seed) : seed_(seed) {
    places_.emplace_back(built(generate_crystal_valley, seed), ivec2(0), crystal_valley::half);
    places_.emplace_back(built(generate_paper_world, seed), village, paper_world::half);
}

const BuiltPlace& EndlessTerrain::nearest_place(ivec2 column) const {
    return *std::ranges::min_element(places_, {}, [&](const BuiltPlace& place) { return place.distance(column); });
}

int EndlessTerrain::height(ivec2 column) const {
    const BuiltPlace& place = nearest_place(column);
    const int distance = place.distance(column);
    if (distance >= blend_width) return landscape::height(seed_, column);
    const int rim = place.rim_height(column);
    return distance == 0 ? rim : blended(rim, landscape::height(seed_, column), distance);
}

int EndlessTerrain::steepness(ivec2 column, int height) const {
    int most = 0;
    for (const ivec2 side : {ivec2(1, 0), ivec2(-1, 0), ivec2(0, 1), ivec2(0, -1)}) {
        most = std::max(most, std::abs(this->height(column + side) - height));
    }
    return most;
}

void EndlessTerrain::fill(VoxelVolume& volume, ivec2 low, ivec2 high) const {
    for (int z = low.y; z < high.y; ++z) {
        for (int x = low.x; x < high.x; ++x) fill_column(volume, {x, z});
    }
    grow_trees(volume, low, high);
}

void EndlessTerrain::fill_column(VoxelVolume& volume, ivec2 column) const {
    const BuiltPlace& place = nearest_place(column);
    place.contains(column) ? place.fill_column(volume, column) : fill_ground(volume, column);
}

void EndlessTerrain::fill_ground(VoxelVolume& volume, ivec2 column) const {
    const auto fill = [&](int low, int high, Block kind) {
        volume.fill({column.x, low, column.y}, {column.x + 1, high, column.y + 1}, kind);
    };
    const int top = height(column);
    const landscape::Ground ground = landscape::ground(seed_, column, top, steepness(column, top));
    fill(landscape::bottom, top - 1 - ground.depth, Block::stone);
    fill(top - 1 - ground.depth, top - 1, ground.below);
    fill(top - 1, top, ground.top);
    fill(top, landscape::sea_level, Block::water);
    if (nearest_place(column).distance(column) < no_caves) return;
    const CaveLine caves(seed_ + cave_seed, column.x, column.y, top);
    for (int y = landscape::bottom; y < top; ++y) {
        int end = y;
        while (end < top && caves.open(end)) ++end;
        fill(y, end, Block::air);
        y = std::max(y, end);
    }
}

bool EndlessTerrain::carries_tree(ivec2 column, int height) const {
    if (height > tree_line || nearest_place(column).distance(column) <= forest::reach) return false;
    if (landscape::ground(seed_, column, height, steepness(column, height)).top != Block::grass) return false;
    return !CaveLine(seed_ + cave_seed, column.x, column.y, height).open(height - 1);
}

void EndlessTerrain::grow_trees(VoxelVolume& volume, ivec2 low, ivec2 high) const {
    const ivec2 first = (low - forest::reach - forest::grid) / forest::grid - 1, last = (high + forest::reach) / forest::grid + 1;
    for (int z = first.y; z <= last.y; ++z) {
        for (int x = first.x; x <= last.x; ++x) {
            const auto seedling = forest::seedling(seed_ + forest_seed, {x, z});
            if (!seedling) continue;
            const ivec2 column = seedling->column;
            const bool reaches = glm::all(glm::greaterThanEqual(column, low - forest::reach)) && glm::all(glm::lessThan(column, high + forest::reach));
            if (!reaches) continue;
            const int ground = height(column);
            if (!carries_tree(column, ground)) continue;
            grow_tree(volume, {column.x, ground, column.y}, forest::shape(*seedling, ground), seedling->seed);
        }
    }
}

}  // namespace sl
