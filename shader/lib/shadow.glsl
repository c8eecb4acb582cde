// SPDX-License-Identifier: MIT
// How much of a light a point sees, from its shadow map.
#include "shared/lights.h"

uniform sampler2DArrayShadow shadow_sun;
uniform sampler2DArrayShadow shadow_spot;

// Four linear comparisons placed so that together they weigh a 3×3 texel tent.
float shadow_tent(sampler2DArrayShadow map, vec3 uv_depth, uint layer) {
    float texel = 1.0 / float(textureSize(map, 0).x);
    float lit = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 offset = vec2((i & 1) == 0 ? -0.5 : 0.5, (i & 2) == 0 ? -0.5 : 0.5) * texel;
        lit += texture(map, vec4(uv_depth.xy + offset, float(layer), uv_depth.z));
    }
    return 0.25 * lit;
}

float shadow_visibility(LightParams light, Incident incident, vec3 position, vec3 normal) {
    if (light.kind.y == no_layer) { return 1.0; }
    bool parallel = light.kind.x == light_directional;
    // A texel's footprint on a tilted surface spans a depth range; stepping off along the normal by the filter's reach
    // clears it, more where the light grazes.
    float cos_light = clamp(dot(normal, incident.to_light.xyz), 0.0, 1.0);
    float sin_light = sqrt(1.0 - cos_light * cos_light);
    float texel = light.direction.w * (parallel ? 1.0 : incident.to_light.w);
    vec3 shifted = position + normal * texel * (0.3 + 2.0 * sin_light) + incident.to_light.xyz * texel * 0.5;
    vec4 clip = light.map_clip_from_world * vec4(shifted, 1.0);
    if (clip.w <= 0.0) { return 0.0; }
    vec3 uv_depth = clip.xyz / clip.w;
    uv_depth.xy = uv_depth.xy * 0.5 + 0.5;
    // Outside its map a sun is taken as unblocked; a spot shines nowhere there.
    return parallel ? shadow_tent(shadow_sun, uv_depth, light.kind.y) : shadow_tent(shadow_spot, uv_depth, light.kind.y);
}
