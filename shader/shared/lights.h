// SPDX-License-Identifier: MIT
#pragma once

#include "shared/constants.h"

SHARED_BEGIN

/// One light. Units as in glTF's KHR_lights_punctual: lux for directional, candela for spot and point.
struct LightParams {
    mat4 map_clip_from_world;  ///< projection of its shadow map and RSM; not of a point light, which has six
    vec4 position;             ///< xyz: m; w: range, m, 0 = without end
    vec4 direction;            ///< xyz: unit vector in which light travels; w: texel of the shadow map (m for directional, else tangent)
    vec4 intensity;            ///< rgb: lux or candela; w: area (m²) or plane area at distance 1 of the whole map
    vec4 cone;                 ///< x: slope, y: height of the ramp at a spot's edge, over 1 - cos of the angle to the axis; z: share of
                               ///< the flux of all lights that bounce
    uvec4 kind;                ///< x: light_*; y: shadow layer, of a point light the first of six; z: RSM layer; w: unused
    vec4 tiles;                ///< of a directional light's shadow map: x: tiles per side, a layer each; yz: place of the lowest one
                               ///< in the ring of layers; w: share of a layer's side that is the tile itself, the rest is its neighbours'.
                               ///< Of a point light's: x: distance of the near plane, m; y: tangent of half a face's angle
};

/// glTF's smooth edge of a spot's cone: 1 inside the inner, 0 outside the outer half angle. Both vectors are unit. Written
/// with 1 - cos = |difference|²/2, which keeps its digits in cones so narrow that all their cosines are 1 in float.
SHARED_FN float cone_falloff(vec4 cone, vec3 axis, vec3 from_light) {
    vec3 difference = from_light - axis;
    float ramp = clamp(cone.y - cone.x * 0.5f * dot(difference, difference), 0.0f, 1.0f);
    return ramp * ramp;
}

/// 1 - cos of the half angle of the cone that a spot or point light shines into; 2 for all directions.
SHARED_FN float cone_versine(LightParams light) { return light.kind.x == light_spot ? min(light.cone.y / light.cone.x, 2.0f) : 2.0f; }

/// glTF's window that ends a light at its range; 1 without a range.
SHARED_FN float range_window(float distance_squared, float range) {
    if (range <= 0.0f) { return 1.0f; }
    float ratio = distance_squared / (range * range);
    return clamp(1.0f - ratio * ratio, 0.0f, 1.0f);
}

/// Which of the six faces of a point light's shadow map shows what lies in a direction: twice the axis, x first, and one more
/// where it points down that axis.
SHARED_FN uint point_face(vec3 from_light) {
    vec3 size = abs(from_light);
    if (size.x >= size.y && size.x >= size.z) { return from_light.x < 0.0f ? 1u : 0u; }
    if (size.y >= size.z) { return from_light.y < 0.0f ? 3u : 2u; }
    return from_light.z < 0.0f ? 5u : 4u;
}

/// A vector as such a face has it: xy across, z along its axis. Every second face shows the world mirrored.
SHARED_FN vec3 in_point_face(vec3 v, uint face) {
    vec3 turned = face < 2u ? vec3(v.y, v.z, v.x) : face < 4u ? vec3(v.z, v.x, v.y) : v;
    return (face & 1u) == 0u ? turned : vec3(turned.x, turned.y, -turned.z);
}

/// Light arriving at a point: from where, and how much on a surface facing it.
struct Incident {
    vec4 to_light;    ///< xyz: unit vector; w: distance, m
    vec4 irradiance;  ///< rgb: lux on a surface facing the light
};

/// Light at a point, as if nothing stood in its way.
SHARED_FN Incident incident_light(LightParams light, vec3 position) {
    Incident result;
    if (light.kind.x == light_directional) {
        result.to_light = vec4(-vec3(light.direction), 1e30f);
        result.irradiance = vec4(vec3(light.intensity), 0.0f);
        return result;
    }
    vec3 offset = vec3(light.position) - position;
    // A point inside the light itself gets a finite answer; 1e-18 keeps 1/d² inside float.
    float distance_squared = max(dot(offset, offset), 1e-18f);
    float distance = sqrt(distance_squared);
    vec3 to_light = offset / distance;
    float falloff = range_window(distance_squared, light.position.w) / distance_squared;
    if (light.kind.x == light_spot) { falloff *= cone_falloff(light.cone, vec3(light.direction), -to_light); }
    result.to_light = vec4(to_light, distance);
    result.irradiance = vec4(vec3(light.intensity) * falloff, 0.0f);
    return result;
}

SHARED_END
