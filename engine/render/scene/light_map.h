// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/render/scene/sun_map.h"
#include "shared/lights.h"

namespace sl {

/// The projection shared by a light's shadow map and its RSM. A spot's shadow map is one layer with this projection, a
/// directional light's may lie in tiles.
struct LightMap {
    mat4 clip_from_world{1.0f};
    float map_area = 0.0f;  ///< m² across the light (directional), or on the plane at distance 1 (spot)
    float half_extent = 0.0f;  ///< m (directional) or tangent (spot; point: of a face): half the map's side
    std::uint64_t key = 0;  ///< hash of the light and of everything in its view: what the RSM is made from
};

/// Where each light's maps lie, and the lights as shaders read them.
struct LightTable {
    std::vector<LightParams> params;         ///< per light
    std::vector<LightMap> maps;              ///< per light; empty for lights without any map
    std::vector<ShadowLayer> sun_layers;     ///< of the directional shadow array
    std::vector<ShadowLayer> next_sun_layers;  ///< of the array that is not in use yet
    std::uint32_t sun_array = 0;             ///< which of two arrays is in use: 0 or 1
    std::vector<ShadowLayer> spot_layers;    ///< of the spot shadow array
    std::vector<std::uint32_t> point_maps;   ///< light index per six layers of the point shadow array
    std::vector<std::uint32_t> rsm_layers;   ///< light index per layer of the RSM arrays
};
/// Parameters of all lights, and the layers of those that have maps.
LightTable build_light_table(const RenderScene& scene);

/// Left, right, bottom and top of what a projection shows, and what is in front (w > 0 for perspective): positive inside. Far
/// does not exist.
std::array<vec4, 5> view_planes(const mat4& clip_from_world);

/// Numbers of those whose bounds touch the volume of a projection.
std::vector<std::uint32_t> visible_draws(std::span<const RenderScene::Draw> draws, const mat4& clip_from_world);
/// Of the scene's draws.
std::vector<std::uint32_t> visible_draws(const RenderScene& scene, const mat4& clip_from_world);

}  // namespace sl
