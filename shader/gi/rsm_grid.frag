// SPDX-License-Identifier: MIT
// Algorithm 1 of "Global illumination based on RSM" (2024), to the letter, one slice of it: a regular grid over the map,
// a distance attenuation with a hard cutoff, and thresholds on angles that drop texels at once.
#include "lib/gbuffer.glsl"
#include "shared/rsm_texel.h"
#include "shared/view.h"

layout(std140) uniform Gather { RsmGatherParams gather; };
uniform sampler2DArray rsm_position;
uniform sampler2DArray rsm_flux;

layout(location = 0) out vec4 partial;

void main() {
    Point point = point_at(ivec2(gl_FragCoord.xy));
    uint size = uint(gather.map.x);
    uint step = uint(gather.grid.w);
    uint side = (size + step - 1u) / step;
    float threshold = gather.grid.x;
    vec3 sum = vec3(0.0);
    for (uint k = gather.slice.x; k < gather.slice.z; k += gather.slice.y) {
        uint within = k % (side * side);
        ivec3 at = ivec3((within % side) * step, (within / side) * step, k / (side * side));
        vec4 texel = texelFetch(rsm_position, at, 0);
        vec4 flux = texelFetch(rsm_flux, at, 0);
        vec3 texel_normal = unpack_texel_normal(flux.a);
        vec3 offset = texel.xyz - point.position;
        float distance_squared = dot(offset, offset);
        float attenuation = 1.0 / (1.0 + gather.grid.y * distance_squared);
        vec3 direction = offset * inversesqrt(max(distance_squared, 1e-20));
        bool dropped = attenuation < gather.grid.z || dot(texel_normal, point.normal) >= threshold ||
                       dot(texel_normal, -direction) <= threshold || dot(point.normal, direction) <= threshold;
        // rsm_colour · light_colour · max(dot(rsm_normal, light_dir), 0) is flux over the texel's own area.
        vec3 colour = flux.rgb / max(texel.w, 1e-20) * attenuation;
        sum += dropped ? vec3(0.0) : colour * max(dot(point.normal, direction), 0.0);
    }
    partial = vec4(point.distance > 0.0 ? sum : vec3(0.0), 1.0);
}
