// SPDX-License-Identifier: MIT
// How much of a light a point sees, from its shadow map.
#include "shared/lights.h"

uniform sampler2DArrayShadow shadow_sun;
uniform sampler2DArrayShadow shadow_spot;
uniform sampler2DArrayShadow shadow_point;

// One linear comparison: four texels, weighted. An edge is a texel wide; the map's size decides how wide that is.
float shadow_compare(sampler2DArrayShadow map, vec3 uv_depth, uint layer) {
    return texture(map, vec4(uv_depth.xy, float(layer), uv_depth.z));
}

// A texel's footprint on a tilted surface spans a depth range; stepping off along the normal by the filter's reach clears
// it, more where the light grazes.
vec3 off_surface(Incident incident, vec3 position, vec3 normal, float texel) {
    float cos_light = clamp(dot(normal, incident.to_light.xyz), 0.0, 1.0);
    float sin_light = sqrt(1.0 - cos_light * cos_light);
    return position + normal * texel * (0.2 + 1.5 * sin_light) + incident.to_light.xyz * texel * 0.5;
}

// Where a point lies in its light's map, moved off the surface.
vec4 shadow_coordinate(LightParams light, Incident incident, vec3 position, vec3 normal, float texel) {
    vec4 clip = light.map_clip_from_world * vec4(off_surface(incident, position, normal, texel), 1.0);
    return vec4(clip.xyz / max(clip.w, 1e-20) * vec3(0.5, 0.5, 1.0) + vec3(0.5, 0.5, 0.0), clip.w);
}

// Outside its map a sun is taken as unblocked.
float sun_visibility(LightParams light, Incident incident, vec3 position, vec3 normal) {
    vec4 at = shadow_coordinate(light, incident, position, normal, light.direction.w);
    float count = light.tiles.x;
    vec2 in_tiles = at.xy * count;
    vec2 tile = clamp(floor(in_tiles), vec2(0.0), vec2(count - 1.0));
    vec2 in_layer = (in_tiles - tile - 0.5) * light.tiles.w + 0.5;
    vec2 place = mod(tile + light.tiles.yz, count);
    uint layer = light.kind.y + uint(place.y * count + place.x);
    return light.kind.y == no_layer ? 1.0 : shadow_compare(shadow_sun, vec3(in_layer, at.z), layer);
}

float spot_visibility(LightParams light, Incident incident, vec3 position, vec3 normal) {
    vec4 at = shadow_coordinate(light, incident, position, normal, light.direction.w * incident.to_light.w);
    if (at.w <= 0.0) { return 0.0; }
    return light.kind.y == no_layer ? 1.0 : shadow_compare(shadow_spot, at.xyz, light.kind.y);
}

// The face is that of the point moved off the surface: each face shows a texel of its neighbours, so that filtering sees no edge.
float point_visibility(LightParams light, Incident incident, vec3 position, vec3 normal) {
    vec3 moved = off_surface(incident, position, normal, light.direction.w * incident.to_light.w);
    uint face = point_face(moved - light.position.xyz);
    vec3 at = in_point_face(moved - light.position.xyz, face);
    float along = max(at.z, 1e-20);
    vec3 uv_depth = vec3(0.5 + 0.5 * at.xy / (along * light.tiles.y), light.tiles.x / along);
    return light.kind.y == no_layer ? 1.0 : shadow_compare(shadow_point, uv_depth, light.kind.y + face);
}
