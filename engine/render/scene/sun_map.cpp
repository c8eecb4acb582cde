// SPDX-License-Identifier: MIT
#include "engine/render/scene/sun_map.h"

#include <algorithm>
#include <cmath>

namespace sl {

namespace {

/// Depth moves in steps of so much, m. A float of 0..1 still tells a millimetre apart.
constexpr float depth_step = 1024.0f;
/// From the middle of the square, in half tiles: the camera is never nearer than three halves to what lies farther.
constexpr int near_tiles = 3;

/// Tiles of one square, and where each has its layer.
struct TileGrid {
    int count = 1;  ///< per side
    ivec2 lowest{0};
    vec2 anchor{0.0f};  ///< corner of tile (0, 0)
    float side = 1.0f;
    float margin = 0.0f;  ///< of the neighbours round a tile

    /// A tile keeps its layer for as long as it is in the square.
    std::size_t layer(ivec2 tile) const {
        const ivec2 place = ring_place(tile);
        return static_cast<std::size_t>(place.y * count + place.x);
    }
    ivec2 ring_place(ivec2 tile) const { return (tile % count + count) % count; }
    vec2 middle(ivec2 tile) const { return anchor + (vec2(tile) + 0.5f) * side; }
    ivec2 tile_at(vec2 position) const {
        // Clamped as floats, because what lies far outside has no whole number.
        return lowest + ivec2(glm::clamp(glm::floor((position - anchor) / side) - vec2(lowest), vec2(-1.0f), vec2(static_cast<float>(count))));
    }
};

TileGrid grid_of(const SunSquare& square, int tiles, std::uint32_t tile_texels) {
    TileGrid grid{.count = tiles, .lowest = square.lowest_tile, .anchor = vec2(0.0f), .side = 2.0f * square.half / static_cast<float>(tiles)};
    if (!square.moves) grid.anchor = square.centre - square.half;
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
        return square;
    }
    square.moves = true;
    square.half = light.shadow_distance;
    square.nearest = std::floor(square.nearest / depth_step) * depth_step;
    square.farthest = std::ceil(square.farthest / depth_step) * depth_step;
    const vec2 eye = vec2(square.light_from_world * vec4(scene.view ? scene.view->position : vec3(0.0f), 1.0f));
    const float step = 2.0f * square.half / static_cast<float>(SunSquare::most_tiles);
    const vec2 steps = glm::round(eye / step);
    square.centre = steps * step;
    square.lowest_tile = ivec2(steps) - SunSquare::most_tiles / 2;
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
            const ivec2 tile = grid.lowest + ivec2(x, y);
            ShadowLayer& layer = result.layers[grid.layer(tile)];
            layer.size = size;
            const vec2 middle = tiles > 1 ? grid.middle(tile) : square.centre;
            layer.clip_from_world = square.clip_from_world(middle, 0.5f * grid.side / whole_tile);
            const ivec2 away = glm::abs(ivec2(x, y) * 2 + 1 - tiles);
            layer.far = std::max(away.x, away.y) > near_tiles;
        }
    }
    const ivec2 last = grid.lowest + tiles - 1;
    for (std::uint32_t i = 0; i < scene.draws.size(); ++i) {
        const Bounds box = transformed(scene.draws[i].bounds, square.light_from_world);
        const ivec2 low = glm::max(grid.tile_at(vec2(box.low) - grid.margin), grid.lowest), high = glm::min(grid.tile_at(vec2(box.high) + grid.margin), last);
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                ShadowLayer& layer = result.layers[grid.layer({x, y})];
                layer.draws.push_back(i);
                // A sum: in which order the draws stand is not seen.
                layer.key += hash_mix(0x5ade, scene.draws[i].content);
            }
        }
    }
    for (ShadowLayer& layer : result.layers) {
        const std::uint64_t place = hash_bytes(layer.size, &layer.clip_from_world, sizeof(mat4));
        layer.key = place >> 32 << 32 | (hash_mix(place, layer.key) & 0xffffffffu) | 1;
        if (layer.key == layer.empty_key() && !layer.draws.empty()) layer.key += 2;
    }
    result.params = vec4(static_cast<float>(tiles), vec2(grid.ring_place(grid.lowest)), whole_tile);
    return result;
}

}  // namespace sl
