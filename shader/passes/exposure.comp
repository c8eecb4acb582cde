// SPDX-License-Identifier: MIT
// Mean of the logarithm of luminance over a grid of pixels, the middle of the picture first; and one step towards the
// exposure that it asks for.
#include "shared/exposure.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(std140) uniform Params { ExposureParams params; };
layout(std430) buffer Exposure { float ev; };
uniform sampler2D hdr;

const uint samples = metered_points / 16u;  // per invocation and axis
shared vec2 sums[256];    // weighted logarithm, weight

void main() {
    vec2 sum = vec2(0.0);
    for (uint i = 0u; i < samples * samples; ++i) {
        vec2 at = (vec2(gl_LocalInvocationID.xy * samples + uvec2(i % samples, i / samples)) + 0.5) / float(metered_points);
        float light = dot(texelFetch(hdr, ivec2(at * vec2(textureSize(hdr, 0))), 0).rgb, vec3(0.2126, 0.7152, 0.0722));
        float weight = metering_weight(at, light);
        if (weight > 0.0) sum += weight * vec2(log2(light), 1.0);
    }
    uint mine = gl_LocalInvocationIndex;
    sums[mine] = sum;
    for (uint half_way = 128u; half_way > 0u; half_way /= 2u) {
        barrier();
        if (mine < half_way) sums[mine] += sums[mine + half_way];
    }
    barrier();
    if (mine != 0u) return;
    if (sums[0].y <= 0.0) {
        // In the dark nothing is adapted to; but the first picture must leave a number.
        if (params.adapt.x >= 1.0) ev = params.adapt.y;
        return;
    }
    float wanted = adapted_ev(sums[0].x / sums[0].y, params);
    ev = params.adapt.x < 1.0 ? mix(ev, wanted, params.adapt.x) : wanted;
}
