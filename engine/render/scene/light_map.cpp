// SPDX-License-Identifier: MIT
#include "engine/render/scene/light_map.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>

#include "engine/core/check.h"

namespace sl {

namespace {

using Light = RenderScene::Light;

bool has_map(const Light& light) { return light.kind != Light::Kind::point && (light.casts_shadow || light.bounces); }

/// The square across a directional light: centre in light space (x, y), half side, and how deep the scene reaches.
struct Square {
    vec2 centre{0.0f};
    float half = 1.0f;
    float nearest = 0.0f, farthest = 1.0f;  ///< along the light, relative to the origin
};

Square fit_square(const RenderScene& scene, const Light& light, const mat4& light_from_world) {
    const Bounds scene_in_light = transformed(scene.bounds, light_from_world);
    Square square;
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
    square.half = light.shadow_distance;
    const vec2 eye = vec2(light_from_world * vec4(scene.view ? scene.view->position : vec3(0.0f), 1.0f));
    const float step = square.half / 8.0f;  // a whole number of texels, for every size that is a multiple of 16
    square.centre = glm::round(eye / step) * step;
    return square;
}

LightMap fit_directional(const RenderScene& scene, const Light& light) {
    const mat4 light_from_world = view_from_world(vec3(0.0f), light.direction, vec3(0, 1, 0));
    const Square square = fit_square(scene, light, light_from_world);
    const float margin = 0.01f * (square.farthest - square.nearest) + 1e-3f * square.half;
    mat4 centred = light_from_world;
    centred[3] -= vec4(square.centre, 0.0f, 0.0f);
    LightMap map;
    map.half_extent = square.half;
    map.clip_from_world =
        reversed_orthographic(square.half, square.half, square.nearest - margin, square.farthest + margin) * centred;
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

}  // namespace

LightMap fit_light_map(const RenderScene& scene, const Light& light) {
    LightMap map = light.kind == Light::Kind::directional ? fit_directional(scene, light) : fit_spot(scene, light);
    map.key = hash_mix(light_hash(light), scene.materials_hash);
    map.key = hash_bytes(map.key, &map.clip_from_world, sizeof(mat4));
    for (const std::uint32_t draw : visible_draws(scene, map.clip_from_world)) {
        map.key = hash_mix(map.key, scene.draws[draw].content);
    }
    return map;
}

LightTable build_light_table(const RenderScene& scene) {
    CHECK(std::ranges::is_sorted(scene.lights, {}, &Light::kind), "lights must stand in the order of their kinds");
    LightTable table;
    for (std::uint32_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const bool mapped = has_map(light) && !scene.draws.empty();
        table.maps.push_back(mapped ? fit_light_map(scene, light) : LightMap{});
        LightParams params = light_params(light, table.maps.back());
        if (mapped && light.casts_shadow) {
            auto& layers = light.kind == Light::Kind::directional ? table.sun_layers : table.spot_layers;
            params.kind.y = static_cast<std::uint32_t>(layers.size());
            layers.push_back(i);
        }
        if (mapped && light.bounces) {
            params.kind.z = static_cast<std::uint32_t>(table.rsm_layers.size());
            table.rsm_layers.push_back(i);
        }
        table.params.push_back(params);
    }
    share_flux(scene, table);
    return table;
}

std::vector<std::uint32_t> visible_draws(const RenderScene& scene, const mat4& clip_from_world) {
    const mat4 rows = glm::transpose(clip_from_world);
    // Left, right, bottom, top; and in front (w > 0 for perspective). Far does not exist, near is harmless to keep.
    const std::array<vec4, 5> planes{rows[3] + rows[0], rows[3] - rows[0], rows[3] + rows[1], rows[3] - rows[1], rows[3]};
    std::vector<std::uint32_t> visible;
    for (std::uint32_t i = 0; i < scene.draws.size(); ++i) {
        const Bounds& box = scene.draws[i].bounds;
        bool outside = false;
        for (const vec4& plane : planes) {
            const vec3 farthest = glm::mix(box.low, box.high, glm::greaterThanEqual(vec3(plane), vec3(0.0f)));
            outside |= glm::dot(vec3(plane), farthest) + plane.w < 0.0f;
        }
        if (!outside) visible.push_back(i);
    }
    return visible;
}

}  // namespace sl
