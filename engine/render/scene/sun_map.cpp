// SPDX-License-Identifier: MIT
#include "engine/render/scene/sun_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace sl {

namespace {

/// Depth moves in steps of so much, m. A float of 0..1 still tells a millimetre apart.
constexpr float depth_step = 1024.0f;
/// So many tiles farther, one has the same number.
constexpr double tile_numbers = 1 << 20;
/// m, across the light: shadows of what the camera's owner changes lie nearer.
constexpr float near_by = 20.0f;

/// Tiles of one square, counted from its lower corner, and where each has its layer.
struct TileGrid {
    int count = 1;  ///< per side
    ivec2 lowest{0};
    vec2 corner{0.0f};  ///< of tile (0, 0)
    float side = 1.0f;
    float margin = 0.0f;  ///< of the neighbours round a tile

    /// A tile keeps its layer for as long as it is in the square.
    std::size_t layer(ivec2 tile) const {
        const ivec2 place = (lowest + tile) % count;
        return static_cast<std::size_t>(place.y * count + place.x);
    }
    vec2 middle(ivec2 tile) const { return corner + (vec2(tile) + 0.5f) * side; }
    /// Of a position outside, one that is outside.
    ivec2 tile_at(vec2 position) const {
        // Clamped as floats, because what lies far outside has no whole number.
        return ivec2(glm::clamp(glm::floor((position - corner) / side), vec2(-1.0f), vec2(static_cast<float>(count))));
    }
};

TileGrid grid_of(const SunSquare& square, int tiles, std::uint32_t tile_texels) {
    TileGrid grid{.count = tiles, .lowest = square.lowest_tile, .corner = square.centre - square.half, .side = 2.0f * square.half / static_cast<float>(tiles)};
    if (tiles > 1) grid.margin = grid.side / static_cast<float>(tile_texels);
    return grid;
}

}  // namespace

mat4 SunSquare::clip_from_world(vec2 middle, float half_side) const {
    const float margin = 0.01f * (farthest - nearest) + 1e-3f * half;
    mat4 centred = light_from_world;
    centred[3] -= vec4(middle, 0.0f, 0.0f);
    return reversed_orthographic(half_side, half_side, nearest - margin, farthest + margin) * centred;
}

SunSquare fit_sun_square(const RenderScene& scene, const RenderScene::Light& light) {
    SunSquare square;
    square.light_from_world = view_from_world(vec3(0.0f), light.direction, vec3(0, 1, 0));
    const Bounds scene_in_light = transformed(scene.bounds, square.light_from_world);
    square.nearest = -scene_in_light.high.z;
    square.farthest = -scene_in_light.low.z;
    const vec3 extent = 0.5f * (scene_in_light.high - scene_in_light.low);
    // One texel of margin keeps the outermost surfaces off the map's border.
    const float whole = std::max(extent.x, extent.y) * (1.0f + 2.0f / static_cast<float>(light.shadow_size));
    if (whole <= light.shadow_distance) {
        square.centre = vec2(scene_in_light.centre());
        square.half = std::max(whole, 1e-6f);
        const mat4 clip_from_world = square.clip_from_world(square.centre, square.half);
        square.world = hash_bytes(hash_bytes(2, &scene.origin, sizeof scene.origin), &clip_from_world, sizeof clip_from_world);
        return square;
    }
    square.moves = true;
    square.half = light.shadow_distance;
    // Steps of tile and depth count from the world's zero, in double: they stay where they are when the origin moves.
    const dvec3 origin = glm::dmat3(mat3(square.light_from_world)) * scene.origin;
    const auto stepped = [&](double depth) { return static_cast<float>(depth * depth_step + origin.z); };
    const double first_depth = std::floor((double{square.nearest} - origin.z) / depth_step), last_depth = std::ceil((double{square.farthest} - origin.z) / depth_step);
    square.nearest = stepped(first_depth);
    square.farthest = stepped(last_depth);
    const double step = 2.0 * square.half / SunSquare::most_tiles;
    const glm::dvec2 eye = glm::dvec2(origin) + glm::dvec2(square.light_from_world * vec4(scene.view ? scene.view->place() : vec3(0.0f), 1.0f));
    const glm::dvec2 tile = glm::round(eye / step);
    square.centre = vec2(tile * step - glm::dvec2(origin));
    square.lowest_tile = ivec2(glm::mod(tile - 0.5 * SunSquare::most_tiles, tile_numbers));
    const std::array<double, 3> lengths{first_depth, last_depth, square.half};
    square.world = hash_bytes(hash_bytes(1, &square.light_from_world, sizeof(mat4)), lengths.data(), sizeof lengths);
    return square;
}

SunLayers sun_layers(const RenderScene& scene, const RenderScene::Light& light, const SunSquare& square, int tiles) {
    const auto per_side = static_cast<std::uint32_t>(tiles);
    const std::uint32_t texels = (light.shadow_size + per_side - 1) / per_side;
    const TileGrid grid = grid_of(square, tiles, texels);
    const std::uint32_t size = tiles > 1 ? texels + 2 : texels;
    const float whole_tile = static_cast<float>(texels) / static_cast<float>(size);
    SunLayers result;
    result.layers.resize(std::size_t{per_side} * per_side);
    for (int y = 0; y < tiles; ++y) {
        for (int x = 0; x < tiles; ++x) {
            const ivec2 tile(x, y);
            ShadowLayer& layer = result.layers[grid.layer(tile)];
            layer.size = size;
            layer.from = -light.direction;
            const vec2 middle = tiles > 1 ? grid.middle(tile) : square.centre;
            layer.clip_from_world = square.clip_from_world(middle, 0.5f * grid.side / whole_tile);
            const ivec2 away = glm::abs(tile * 2 + 1 - tiles), number = (grid.lowest + tile) % static_cast<int>(tile_numbers);
            layer.key = hash_bytes(hash_mix(square.world, layer.size), &number, sizeof number) >> 32 << 32;
            // The camera is within half a tile of the square's middle.
            layer.may_wait = 0.5f * static_cast<float>(std::max(away.x, away.y) - 2) * grid.side > near_by;
        }
    }
    std::vector<std::uint64_t> contents(result.layers.size());
    std::vector<char> edited(result.layers.size());
    for (std::uint32_t i = 0; i < scene.draws.size(); ++i) {
        const Bounds box = transformed(scene.draws[i].bounds, square.light_from_world);
        const ivec2 low = glm::max(grid.tile_at(vec2(box.low) - grid.margin), ivec2(0)), high = glm::min(grid.tile_at(vec2(box.high) + grid.margin), ivec2(tiles - 1));
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                const std::size_t layer = grid.layer({x, y});
                result.layers[layer].draws.push_back(i);
                if (!scene.draws[i].changed.empty()) edited[layer] = 1;
                // A sum: in which order the draws stand is not seen.
                contents[layer] += hash_mix(0x5ade, scene.draws[i].content);
            }
        }
    }
    for (std::size_t i = 0; i < contents.size(); ++i) {
        ShadowLayer& layer = result.layers[i];
        // What came by itself came far off, but along a low sun that may be in the camera's own tile.
        layer.may_wait |= edited[i] == 0;
        layer.key |= (hash_mix(layer.key, contents[i]) & 0xffffffffu) | 1;
        if (layer.key == layer.empty_key() && !layer.draws.empty()) layer.key += 2;
    }
    result.params = vec4(static_cast<float>(tiles), vec2(grid.lowest % tiles), whole_tile);
    return result;
}

}  // namespace sl
