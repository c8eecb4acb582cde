// SPDX-License-Identifier: MIT
// Screen-space interpolation: a pixel takes the bilinear mean of its four low-resolution neighbours that lie on the same
// surface; where fewer than three do, it is marked to gather for itself.
#include "lib/gbuffer.glsl"
#include "shared/view.h"

layout(std140) uniform Gather { RsmGatherParams gather; };
uniform sampler2D irradiance_low;

layout(location = 0) out vec4 irradiance;
layout(location = 1) out vec4 refined;  // white where the pixel must gather

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Point point = point_at(pixel);
    int spacing = int(gather.disc.w);
    ivec2 last_pixel = ivec2(frame.ray_right.w, frame.ray_up.w) - 1;
    ivec2 last_cell = textureSize(irradiance_low, 0) - 1;
    vec2 cell = (vec2(pixel) - float(spacing / 2)) / float(spacing);
    ivec2 corner = ivec2(floor(cell));
    vec2 share = cell - vec2(corner);
    vec4 sum = vec4(0.0);
    int agreeing = 0;
    for (int i = 0; i < 4; ++i) {
        ivec2 step = ivec2(i & 1, i >> 1);
        ivec2 neighbour = clamp(corner + step, ivec2(0), last_cell);
        Point other = point_at(min(neighbour * spacing + spacing / 2, last_pixel));
        // On the same surface: facing alike, and each on the other's plane up to a share of the viewing distance.
        float off_plane = max(abs(dot(other.position - point.position, point.normal)), abs(dot(other.position - point.position, other.normal)));
        bool same = other.distance > 0.0 && dot(other.normal, point.normal) >= gather.tolerance.y && off_plane <= gather.tolerance.x * point.distance;
        vec2 near = mix(1.0 - share, share, vec2(step));
        float weight = same ? max(near.x * near.y, 1e-4) : 0.0;
        sum += vec4(texelFetch(irradiance_low, neighbour, 0).rgb, 1.0) * weight;
        agreeing += same ? 1 : 0;
    }
    bool surface = point.distance > 0.0;
    irradiance = vec4(surface ? sum.rgb / max(sum.a, 1e-6) : vec3(0.0), 1.0);
    refined = vec4(surface && agreeing < 3 ? 1.0 : 0.0);
}
