// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/render/scene/render_scene.h"

namespace sl {

/// One layer of an array of shadow maps, drawn by itself and only when something in its view changes.
struct ShadowLayer {
    std::uint32_t size = 1;  ///< texels per side
    mat4 clip_from_world{1.0f};
    std::uint64_t key = 0;  ///< hash of what it is made from; in a sun's tile, the upper half is that of the tile alone
    std::vector<std::uint32_t> draws;
    vec3 from{0.0f};  ///< unit, towards a light so far off that it is in no solid thing, and what faces away throws no shadow of its own; else 0
    bool may_wait = false;  ///< nobody looks at what is out of date in it
    bool in_view = true;    ///< else nothing of the picture lies in it: it is not drawn

    /// The key of a sun's tile in which nothing stands.
    std::uint64_t empty_key() const { return key >> 32 << 32 | 1; }
};

/// The square across a directional light that its maps show, in the light's own space. It is divided into tiles, whose
/// place in the world stays where it is when the square or the scene's origin moves: a tile that stays inside need not be
/// drawn again.
struct SunSquare {
    static constexpr int most_tiles = 8;  ///< per side

    mat4 light_from_world{1.0f};
    vec2 centre{0.0f};
    float half = 1.0f;
    float nearest = 0.0f, farthest = 1.0f;  ///< along the light, relative to the origin
    bool moves = false;                     ///< with the camera, because the scene is larger
    ivec2 lowest_tile{0};  ///< where it moves: the tile at its lower corner, counted from the world's zero, modulo 2^20
    std::uint64_t world = 0;  ///< hash of what a tile depends on besides its number and size, wherever the origin is

    /// Projection of a square with the same depth.
    mat4 clip_from_world(vec2 middle, float half_side) const;
};

/// Covers the whole scene where that is smaller than the light's shadow distance; otherwise what lies round the camera, in
/// whole steps of a tile. Its depth has room to spare then, or each mesh that comes would change all tiles.
SunSquare fit_sun_square(const RenderScene& scene, const RenderScene::Light& light);

/// The layers of a directional light's shadow map.
struct SunLayers {
    std::vector<ShadowLayer> layers;
    vec4 params{1, 0, 0, 1};  ///< LightParams::tiles
};
/// `tiles` per side: 1 or most_tiles. Each tile has a texel of its neighbours round it, so that filtering sees no edge.
SunLayers sun_layers(const RenderScene& scene, const RenderScene::Light& light, const SunSquare& square, int tiles);

}  // namespace sl
