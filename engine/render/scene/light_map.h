// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/render/scene/render_scene.h"
#include "shared/lights.h"

namespace sl {

/// The projection shared by a light's shadow map and its RSM.
struct LightMap {
    mat4 clip_from_world{1.0f};
    float map_area = 0.0f;  ///< m² across the light (directional), or on the plane at distance 1 (spot)
    float half_extent = 0.0f;  ///< m (directional) or tangent (spot): half the map's side
    std::uint64_t key = 0;  ///< hash of the light and of everything in its view: what the map is made from
};

/// Fits a light's map. A directional light's covers the whole scene where that is smaller than its shadow distance,
/// and then never moves; otherwise a square around the camera that moves in whole steps of many texels, so that edges
/// neither crawl nor need redrawing at each frame. Whatever stands between the light and the square is inside.
LightMap fit_light_map(const RenderScene& scene, const RenderScene::Light& light);

/// Where each light's maps lie, and the lights as shaders read them.
struct LightTable {
    std::vector<LightParams> params;         ///< per light
    std::vector<LightMap> maps;              ///< per light; empty for lights without any map
    std::vector<std::uint32_t> sun_layers;   ///< light index per layer of the directional shadow array
    std::vector<std::uint32_t> spot_layers;  ///< light index per layer of the spot shadow array
    std::vector<std::uint32_t> rsm_layers;   ///< light index per layer of the RSM arrays
};
LightTable build_light_table(const RenderScene& scene);

/// Draws whose bounds touch the volume of a projection.
std::vector<std::uint32_t> visible_draws(const RenderScene& scene, const mat4& clip_from_world);

}  // namespace sl
