// SPDX-License-Identifier: MIT
// Finishes the exact sum: for the texels around each receiver's projection, where a disc is a poor stand-in for a patch
// (a receiver at the foot of a lit wall sees mostly the nearest texels), the disc's share is replaced by the patch's true
// form factor. Texels further off in the map are further off in space as well, and for them the disc is good.
#include "lib/gbuffer.glsl"
#include "shared/lights.h"
#include "shared/rsm.h"
#include "shared/view.h"

layout(std140) uniform Gather { RsmGatherParams gather; };
layout(std430) readonly buffer Texels { RsmTexel texels[]; };
layout(std430) readonly buffer Lights { LightParams lights[]; };
uniform sampler2D partial;

layout(location = 0) out vec4 irradiance;

const int reach = 4;  // texels; beyond, disc and patch differ by less than 0.3 %

vec3 correction(LightParams light, RsmTexel texel, Point point) {
    float area = texel.position.w;
    vec3 offset = texel.position.xyz - point.position;
    vec3 normal = texel.normal.xyz;
    if (area <= 0.0 || dot(normal, offset) >= 0.0) { return vec3(0.0); }
    // Half a texel along the map's axes, moved along the light's ray onto the surface: the patch's own edges.
    mat4 rows = transpose(light.map_clip_from_world);
    float w = dot(rows[3], vec4(texel.position.xyz, 1.0)) / gather.map.x;
    vec3 across = rows[0].xyz / dot(rows[0].xyz, rows[0].xyz) * w;
    vec3 up = rows[1].xyz / dot(rows[1].xyz, rows[1].xyz) * w;
    vec3 ray = light.kind.x == light_directional ? light.direction.xyz : normalize(texel.position.xyz - light.position.xyz);
    float slope = min(dot(ray, normal), -1e-3);
    vec3 u = across - ray * (dot(across, normal) / slope);
    vec3 v = up - ray * (dot(up, normal) / slope);
    vec3 patch_light = texel.flux.rgb / area * parallelogram_form_factor(offset, u, v, point.normal);
    return patch_light - texel_irradiance(texel.flux.rgb, texel.position.xyz, normal, area, point.position, point.normal);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Point point = point_at(pixel);
    int size = int(gather.map.x);
    vec3 sum = texelFetch(partial, pixel, 0).rgb;
    uint count = point.distance > 0.0 ? frame.counts.x : 0u;
    for (uint i = 0u; i < count; ++i) {
        LightParams light = lights[i];
        if (light.kind.z == no_layer) { continue; }
        vec4 clip = light.map_clip_from_world * vec4(point.position, 1.0);
        vec2 at = clip.w > 0.0 ? clip.xy / clip.w * 0.5 + 0.5 : vec2(-1e4);
        ivec2 centre = ivec2(clamp(at, vec2(-2.0), vec2(3.0)) * float(size));
        for (int y = max(centre.y - reach, 0); y <= min(centre.y + reach, size - 1); ++y) {
            for (int x = max(centre.x - reach, 0); x <= min(centre.x + reach, size - 1); ++x) {
                sum += correction(light, texels[int(light.kind.z) * size * size + y * size + x], point);
            }
        }
    }
    irradiance = vec4(point.distance > 0.0 ? max(sum, vec3(0.0)) * gather.map.z : vec3(0.0), 1.0);
}
