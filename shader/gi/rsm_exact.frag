// SPDX-License-Identifier: MIT
// Adds one slice of the sum over every texel of every RSM.
#include "lib/gbuffer.glsl"
#include "shared/rsm.h"
#include "shared/view.h"

layout(std140) uniform Gather { RsmGatherParams gather; };
layout(std430) readonly buffer Texels { RsmTexel texels[]; };

layout(location = 0) out vec4 partial;

void main() {
    Point point = point_at(ivec2(gl_FragCoord.xy));
    vec3 sum = vec3(0.0);
    for (uint i = gather.slice.x; i < gather.slice.z; i += gather.slice.y) {
        vec4 position = texels[i].position;
        sum += texel_irradiance(texels[i].flux.rgb, position.xyz, texels[i].normal.xyz, position.w, point.position, point.normal);
    }
    partial = vec4(point.distance > 0.0 ? sum : vec3(0.0), 1.0);
}
