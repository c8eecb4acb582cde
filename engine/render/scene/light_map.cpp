// SPDX-License-Identifier: MIT
#include "engine/render/scene/light_map.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "engine/core/check.h"
#include "engine/render/scene/point_map.h"

namespace sl {

namespace {

using Light = RenderScene::Light;

bool has_map(const Light& light) {
    return light.mapped && (light.casts_shadow || (light.bounces && light.kind != Light::Kind::point));
}

LightMap map_of(const SunSquare& square) {
    LightMap map;
    map.half_extent = square.half;
    map.clip_from_world = square.clip_from_world(square.centre, square.half);
    map.map_area = 4.0f * square.half * square.half;
    return map;
}

LightMap fit_spot(const RenderScene& scene, const Light& light) {
    // One texel of margin: the cone's edge stays off the map's border.
    const float tangent = std::tan(light.outer_cone) * (1.0f + 2.0f / static_cast<float>(light.shadow_size));
    // With reversed depth and no far plane precision does not depend on the near plane: it may hug the light.
    const float near = std::max(1e-5f * scene.bounds.radius(), 1e-12f);
    LightMap map;
    map.half_extent = tangent;
    map.clip_from_world = reversed_infinite_perspective(2.0f * std::atan(tangent), 1.0f, near) *
                          view_from_world(light.position, light.direction, vec3(0, 1, 0));
    map.map_area = 4.0f * tangent * tangent;
    return map;
}

std::uint64_t light_hash(const Light& light) {
    const std::array<float, 14> values{static_cast<float>(light.kind), light.position.x, light.position.y,
                                       light.position.z, light.direction.x, light.direction.y, light.direction.z,
                                       light.intensity.x, light.intensity.y, light.intensity.z, light.range,
                                       light.inner_cone, light.outer_cone, static_cast<float>(light.shadow_size)};
    return hash_bytes(0x11947, values.data(), sizeof values);
}

/// 1 - cos without losing digits near 0.
double versine(double angle) { return 2.0 * std::pow(std::sin(0.5 * angle), 2.0); }

/// glTF's sample code never lets the ramp be narrower than 0.001 in the cosine, which all but puts out lights of less than
/// 2.5°. A share of the cone serves as well against a division by zero, and leaves a hard edge hard.
vec4 cone_ramp(double inner, double outer) {
    const double edge = versine(outer), width = std::max(edge - versine(inner), 1e-4 * edge + 1e-15);
    return vec4(1.0 / width, edge / width, 0.0, 0.0);
}

LightParams light_params(const Light& light, const LightMap& map) {
    LightParams params{};
    params.map_clip_from_world = map.clip_from_world;
    params.position = vec4(light.position, light.range);
    params.direction = vec4(light.direction, 2.0f * map.half_extent / static_cast<float>(light.shadow_size));
    params.intensity = vec4(light.intensity, map.map_area);
    params.cone = cone_ramp(light.inner_cone, light.outer_cone);
    params.kind = uvec4(static_cast<std::uint32_t>(light.kind), no_layer, no_layer, 0);
    params.tiles = vec4(1, 0, 0, 1);
    return params;
}

/// Lumen that a light throws into its map.
double flux_of(const Light& light, const LightMap& map) {
    // Not luminance: all three channels are gathered alike.
    const double strength = double{light.intensity.x} + light.intensity.y + light.intensity.z;
    const double extent = light.kind == Light::Kind::directional ? double{map.map_area} : 2.0 * glm::pi<double>() * (1.0 - std::cos(double{light.outer_cone}));
    return strength * extent;
}

void share_flux(const RenderScene& scene, LightTable& table) {
    double total = 0.0;
    for (const std::uint32_t light : table.rsm_layers) total += flux_of(scene.lights[light], table.maps[light]);
    if (total <= 0.0) return;
    for (const std::uint32_t light : table.rsm_layers) {
        table.params[light].cone.z = static_cast<float>(flux_of(scene.lights[light], table.maps[light]) / total);
    }
}

/// Suns whose shadows are drawn, with their squares.
using Suns = std::vector<std::pair<std::uint32_t, SunSquare>>;

void add_sun_layers(const RenderScene& scene, const Suns& suns, LightTable& table) {
    // All layers of an array are of one size, so all suns have as many tiles.
    const bool moves = std::ranges::any_of(suns, [](const auto& sun) { return sun.second.moves; });
    for (const auto& [light, square] : suns) {
        SunLayers made = sun_layers(scene, scene.lights[light], square, moves ? SunSquare::most_tiles : 1);
        table.params[light].kind.y = static_cast<std::uint32_t>(table.sun_layers.size());
        table.params[light].tiles = made.params;
        std::ranges::move(made.layers, std::back_inserter(table.sun_layers));
    }
}

std::uint64_t content_key(const RenderScene& scene, const Light& light, const LightMap& map, const std::vector<std::uint32_t>& draws) {
    std::uint64_t key = hash_mix(light_hash(light), scene.materials_hash);
    key = hash_bytes(hash_bytes(key, &scene.origin, sizeof scene.origin), &map.clip_from_world, sizeof(mat4));
    for (const std::uint32_t draw : draws) key = hash_mix(key, scene.draws[draw].content);
    return key;
}

}  // namespace

LightTable build_light_table(const RenderScene& scene) {
    CHECK(std::ranges::is_sorted(scene.lights, {}, &Light::kind), "lights must stand in the order of their kinds");
    LightTable table;
    Suns suns;
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const bool mapped = has_map(light) && !scene.draws.empty(), sun = light.kind == Light::Kind::directional, spot = light.kind == Light::Kind::spot;
        LightMap& map = table.maps.emplace_back();
        std::vector<std::uint32_t> seen;
        if (mapped && sun) {
            const SunSquare square = fit_sun_square(scene, light);
            map = map_of(square);
            if (light.casts_shadow) suns.emplace_back(i, square);
        } else if (mapped && spot) {
            map = fit_spot(scene, light);
        } else if (mapped) {
            map.half_extent = point_face_tangent(light);
        }
        if (mapped && (spot || (sun && light.bounces))) {
            seen = visible_draws(scene, map.clip_from_world);
            map.key = content_key(scene, light, map, seen);
        }
        LightParams& params = table.params.emplace_back(light_params(light, map));
        if (mapped && light.casts_shadow && spot) {
            params.kind.y = static_cast<std::uint32_t>(table.spot_layers.size());
            table.spot_layers.push_back({.size = light.shadow_size, .clip_from_world = map.clip_from_world, .key = map.key, .draws = std::move(seen)});
        }
        if (mapped && !sun && !spot) {
            params.kind.y = static_cast<std::uint32_t>(point_face_count * table.point_maps.size());
            params.tiles = vec4(point_near_plane(scene, light), map.half_extent, 0.0f, 0.0f);
            table.point_maps.push_back(i);
        } else if (mapped && light.bounces) {
            params.kind.z = static_cast<std::uint32_t>(table.rsm_layers.size());
            table.rsm_layers.push_back(i);
        }
    }
    add_sun_layers(scene, suns, table);
    share_flux(scene, table);
    return table;
}

std::array<vec4, 5> view_planes(const mat4& clip_from_world) {
    const mat4 rows = glm::transpose(clip_from_world);
    return {rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1], rows[3]};
}

std::vector<std::uint32_t> visible_draws(std::span<const RenderScene::Draw> draws, const mat4& clip_from_world) {
    const std::array<vec4, 5> planes = view_planes(clip_from_world);
    std::vector<std::uint32_t> visible;
    for (std::uint32_t i = 0; i < draws.size(); ++i) {
        const Bounds& box = draws[i].bounds;
        bool outside = false;
        for (const vec4& plane : planes) {
            const vec3 farthest = glm::mix(box.low, box.high, glm::greaterThanEqual(vec3(plane), vec3(0.0f)));
            outside |= glm::dot(vec3(plane), farthest) + plane.w < 0.0f;
        }
        if (!outside) visible.push_back(i);
    }
    return visible;
}

std::vector<std::uint32_t> visible_draws(const RenderScene& scene, const mat4& clip_from_world) {
    return visible_draws(scene.draws, clip_from_world);
}

}  // namespace sl
