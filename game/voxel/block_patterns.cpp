// SPDX-License-Identifier: MIT
#include "game/voxel/block_patterns.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

#include "engine/core/check.h"
#include "game/voxel/lattice_noise.h"

namespace sl {
namespace {

constexpr int size = block_texture_size;

int noise(std::uint32_t seed, int x, int y, int cell_x, int cell_y) {
    return value_noise(seed, x, y, cell_x, cell_y, size);
}

/// Picks one of a few shades, as a painter with a small palette does.
template <std::size_t count>
int shade(const std::array<int, count>& shades, int noise_1024) {
    return shades[static_cast<std::size_t>(noise_1024) * count / 1024];
}

int speckle(std::uint32_t seed, int x, int y) {
    return lattice_pick(seed, x, y, 1024);
}

PatternTexel grass(std::uint32_t seed, int x, int y) {
    const int patch = (noise(seed, x, y, 4, 4) - 512) / 20;
    const int blade = shade(std::array{-58, -34, -14, 0, 0, 14, 30, 52}, speckle(seed + 1, x, y));
    return {256 + patch + blade, speckle(seed + 2, x, y) < 150 ? 110 : 0};
}

PatternTexel dirt(std::uint32_t seed, int x, int y) {
    const int clod =
        shade(std::array{-50, -24, 0, 22, 40}, (noise(seed, x, y, 2, 2) + speckle(seed + 1, x, y)) / 2);
    const bool pebble = speckle(seed + 2, x, y) < 46;
    return {256 + clod, pebble ? 190 : 0};
}

PatternTexel grass_side(std::uint32_t seed, int x, int y) {
    const int depth = 4 + lattice_pick(seed, x, 0, 3) - (lattice_pick(seed, x / 2, 1, 3) == 0 ? 1 : 0);
    const int from_top = size - 1 - y;
    if (from_top < depth) return {grass(seed + 1, x, y).light - 6 * from_top, 256};
    PatternTexel soil = dirt(seed + 2, x, y);
    if (from_top == depth) soil.light -= 70;
    soil.accent = 0;
    return soil;
}

PatternTexel stone(std::uint32_t seed, int x, int y) {
    const int layer = (2 * noise(seed, x, y, 8, 4) + noise(seed + 1, x, y, 4, 2)) / 3;
    const int grain = (speckle(seed + 2, x, y) - 512) / 40;
    const bool crack = lattice_pick(seed + 3, (x + y % 2) / 3, y, 1024) < 90;
    return {256 + shade(std::array{-44, -18, 0, 18, 36}, layer) + grain - (crack ? 40 : 0), 0};
}

PatternTexel sand(std::uint32_t seed, int x, int y) {
    const int dune = (noise(seed, x, y, 8, 4) - 512) / 26;
    return {256 + dune + shade(std::array{-28, -10, 0, 0, 10, 24}, speckle(seed + 1, x, y)), 0};
}

PatternTexel water(std::uint32_t seed, int x, int y) {
    const int swell = (noise(seed, x, y, 8, 4) - 512) / 10;
    const int ripple = noise(seed + 1, x, y, 8, 2);
    return {256 + swell / 2, ripple > 690 ? 120 : ripple > 560 ? 50 : 0};
}

PatternTexel rings(std::uint32_t seed, int x, int y) {
    const int across = std::abs(2 * x - (size - 1));
    const int up = std::abs(2 * y - (size - 1));
    if (std::max(across, up) >= size - 1) return {240 + (speckle(seed, x, y) - 512) / 12, 256};
    // Between a square's and a diamond's distance, so that the rings round their corners.
    const int radius =
        (3 * std::max(across, up) + (across + up) / 2) / 4 + (noise(seed + 1, x, y, 4, 4) - 512) / 400;
    const bool dark = (radius / 2) % 2 == 0;
    return {dark ? 206 : 284, dark ? 40 : 0};
}

PatternTexel bark(std::uint32_t seed, int x, int y) {
    const int fibre = noise(seed, x, y, 2, 8);
    const bool groove = noise(seed + 1, x, y, 2, 16) > 610 && speckle(seed + 2, x, y / 3) < 800;
    return {256 + shade(std::array{-52, -18, 12, 40}, fibre) - (groove ? 70 : 0), 0};
}

PatternTexel planks(std::uint32_t seed, int x, int y) {
    const int plank = y / 4;
    const int joint = (plank % 2 == 0 ? 3 : 11) + lattice_pick(seed, plank, 0, 3);
    const int board = plank * 2 + (x > joint ? 1 : 0);
    if (y % 4 == 0) return {150 + (speckle(seed + 1, x, y) - 512) / 40, 0};
    if (x == joint) return {172, 0};
    const int grain =
        shade(std::array{-30, -10, 6, 22}, noise(seed + 2 + static_cast<std::uint32_t>(board), x, y, 8, 1));
    return {268 + grain + lattice_pick(seed + 3, board, 0, 33) - 16 + (y % 4 == 3 ? 12 : 0), 0};
}

PatternTexel leaves(std::uint32_t seed, int x, int y) {
    const int clump =
        (noise(seed, x, y, 4, 4) + 2 * noise(seed + 1, x, y, 2, 2) + speckle(seed + 2, x, y)) / 4;
    const int lit = (clump - 260) * 2;
    const int light = shade(std::array{108, 176, 232, 282, 330, 372}, std::clamp(lit, 0, 1023));
    return {light, light >= 330 ? 130 : 0};
}

struct Cell {
    int identity = 0;
    int edge = 0;  ///< 0 at the border between two cells
    int up = 0;    ///< how far above the cell's middle
};

/// Voronoi cells of one jittered point per 4 x 4 texels, on a torus.
Cell pebble_cell(std::uint32_t seed, int x, int y) {
    constexpr int grid = 4;
    int nearest = std::numeric_limits<int>::max();
    int second = nearest;
    Cell cell;
    for (int row = y / grid - 2; row <= y / grid + 2; ++row) {
        for (int column = x / grid - 2; column <= x / grid + 2; ++column) {
            const int name = (column & 3) + 4 * (row & 3);
            const int away_x = 2 * x + 1 - 2 * grid * column - lattice_pick(seed, name, 0, 2 * grid);
            const int away_y = 2 * y + 1 - 2 * grid * row - lattice_pick(seed, name, 1, 2 * grid);
            const int distance = away_x * away_x + away_y * away_y;
            if (distance < nearest) {
                second = nearest;
                nearest = distance;
                cell = {name, 0, away_y};
            } else {
                second = std::min(second, distance);
            }
        }
    }
    cell.edge = second - nearest;
    return cell;
}

PatternTexel cobblestone(std::uint32_t seed, int x, int y) {
    const Cell cell = pebble_cell(seed, x, y);
    if (cell.edge < 12) return {152 + (speckle(seed + 1, x, y) - 512) / 40, 0};
    return {246 + lattice_pick(seed + 2, cell.identity, 0, 64) - 24 + std::clamp(6 * cell.up, -24, 30) +
                (speckle(seed + 3, x, y) - 512) / 40,
            0};
}

PatternTexel brick(std::uint32_t seed, int x, int y) {
    const int course = y / 4;
    const int along = (x + (course % 2) * 4) % size;
    if (y % 4 == 0 || along % 8 == 0) return {236 + (speckle(seed, x, y) - 512) / 36, 256};
    const int one_brick = lattice_pick(seed + 1, along / 8, course, 80) - 40;
    return {256 + one_brick + (y % 4 == 3 ? 18 : 0) + (speckle(seed + 2, x, y) - 512) / 26, 0};
}

PatternTexel snow(std::uint32_t seed, int x, int y) {
    const int drift = (noise(seed, x, y, 8, 8) - 512) / 40;
    return {252 + drift / 2, speckle(seed + 1, x, y) < 120 ? 150 : 0};
}

PatternTexel glass(std::uint32_t seed, int x, int y) {
    if (x == 0 || y == 0 || x == size - 1 || y == size - 1) return {256, 256};
    const int diagonal = x - y;
    const bool glint = (diagonal == 3 || diagonal == 4 || diagonal == -5) && (x + y) % 13 > 2;
    return {248 + (noise(seed, x, y, 8, 8) - 512) / 60, glint ? 160 : 0};
}

PatternTexel wool(std::uint32_t seed, int x, int y) {
    const int tuft = (noise(seed, x, y, 4, 2) - 512) / 24;
    const int weave = (x + 2 * (y / 2)) % 4 < 2 ? 10 : -8;
    return {256 + tuft + weave + (speckle(seed + 1, x, y) - 512) / 34, 0};
}

PatternTexel glowstone(std::uint32_t seed, int x, int y) {
    const Cell cell = pebble_cell(seed, x, y);
    const int core = std::clamp(cell.edge * 6, 0, 256);
    return {200 + core / 4 + (speckle(seed + 1, x, y) - 512) / 30, core};
}

PatternTexel lamp(std::uint32_t seed, int x, int y) {
    const int from_edge = std::min({x, y, size - 1 - x, size - 1 - y});
    if (from_edge == 0) return {150, 0};
    return {250 + 4 * from_edge + (speckle(seed, x, y) - 512) / 40, from_edge > 2 ? 40 * (from_edge - 2) : 0};
}

PatternTexel metal(std::uint32_t seed, int x, int y) {
    const int brushed = (noise(seed, x, y, 8, 1) - 512) / 30;
    if (y == size - 1 || x == 0) return {274 + brushed / 2, 0};
    if (y == 0 || x == size - 1) return {196 + brushed / 2, 0};
    const bool rivet = (x == 2 || x == 13) && (y == 2 || y == 13);
    return {(rivet ? 214 : 254) + brushed + (y - 7), 0};
}

constexpr std::array<LayerDesign, block_layer_count> designs{{
    {grass, {92, 218, 46}, {150, 236, 60}},
    {grass_side, {190, 118, 68}, {96, 214, 48}},
    {dirt, {190, 118, 68}, {260, 215, 170}},
    {stone, {292, 294, 300}, {}},
    {sand, {600, 510, 330}, {}},
    {water, {28, 98, 178}, {90, 205, 280}},
    {rings, {470, 330, 180}, {150, 98, 52}},
    {bark, {165, 108, 58}, {}},
    {planks, {450, 330, 190}, {}},
    {leaves, {46, 125, 26}, {92, 170, 34}},
    {planks, {750, 50, 40}, {}},
    {cobblestone, {270, 272, 278}, {}},
    {brick, {400, 120, 80}, {430, 410, 380}},
    {snow, {865, 870, 875}, {780, 825, 880}},
    {glass, {560, 700, 740}, {780, 850, 870}},
    {wool, {800, 800, 790}, {}},
    {wool, {105, 320, 60}, {}},
    {wool, {55, 90, 420}, {}},
    {wool, {760, 560, 60}, {}},
    {wool, {560, 45, 40}, {}},
    {wool, {740, 270, 40}, {}},
    {wool, {28, 28, 32}, {}},
    {glowstone, {560, 300, 90}, {900, 740, 420}},
    {metal, {560, 570, 580}, {}},
    {metal, {900, 690, 300}, {}},
    {lamp, {860, 40, 30}, {940, 150, 110}},
    {lamp, {50, 760, 60}, {180, 900, 190}},
    {lamp, {40, 110, 900}, {150, 230, 950}},
    {lamp, {900, 380, 30}, {950, 520, 120}},
}};

}  // namespace

const LayerDesign& layer_design(BlockLayer layer) {
    const auto index = static_cast<std::size_t>(layer);
    CHECK(index < designs.size(), "texture layer {} of {}", index, designs.size());
    return designs[index];
}

}  // namespace sl
