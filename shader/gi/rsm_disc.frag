// SPDX-License-Identifier: MIT
// Gathers at every pixel of the target: the whole screen, or one pixel in the middle of each low-resolution cell.
#include "lib/gbuffer.glsl"
#include "lib/rsm_disc.glsl"

layout(location = 0) out vec4 irradiance;

void main() {
    int spacing = int(gather.disc.w);
    ivec2 last = ivec2(frame.ray_right.w, frame.ray_up.w) - 1;
    ivec2 pixel = min(ivec2(gl_FragCoord.xy) * spacing + spacing / 2, last);
    Point point = point_at(pixel);
    irradiance = vec4(gather_disc(point, pixel, point.distance > 0.0 ? uint(gather.disc.x) : 0u), 1.0);
}
