// SPDX-License-Identifier: MIT
// The picture without any water's surface, for a camera in it.
#include "lib/water.glsl"

uniform sampler2D hdr;

layout(location = 0) out vec4 hdr_water;  // rgb: radiance, nit

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 straight = texelFetch(hdr, pixel, 0).rgb;
    hdr_water = vec4(seen_through(straight, distance_at(depth, pixel), body(frame.camera_position.xyz, sky_share(pixel))), 1.0);
}
