// SPDX-License-Identifier: MIT
// Gathers at the listed pixels: a work group per row.
#include "lib/gbuffer.glsl"
#include "lib/row_list.glsl"
#include "lib/rsm_disc.glsl"

layout(local_size_x = 64) in;
layout(std430) readonly buffer Pixels { uint pixels[]; };
layout(rgba32f) uniform writeonly image2D irradiance;

void main() {
    uint row = gl_WorkGroupID.x;
    uint width = uint(frame.ray_right.w);
    uint count = pixels[row_list_count(row, width)];
    for (uint i = gl_LocalInvocationID.x; i < count; i += 64u) {
        ivec2 pixel = ivec2(pixels[row_list_entry(row, width, i)], row);
        imageStore(irradiance, pixel, vec4(gather_disc(point_at(pixel), pixel, uint(gather.disc.x)), 1.0));
    }
}
