// SPDX-License-Identifier: MIT
// The specular lobe's integrals over all directions of light, for each view and roughness.
#include "shared/specular_lobe.h"

layout(location = 0) out vec2 lobe;  // x: without Fresnel's term, y: times (1 - v·h)⁵

// A Fibonacci lattice. Rows and columns would step over the edge where light sinks below the surface all at once: 256 of
// them err by 1.5 %, these by 0.2 % at most.
const uint samples = 377u, stride = 233u;

void main() {
    vec2 place = (gl_FragCoord.xy - 0.5) / float(specular_lobe_size - 1u);
    float n_dot_v = max(place.x * place.x, 1e-4);
    vec2 sum = vec2(0.0);
    for (uint i = 0u; i < samples; ++i) {
        vec2 xi = (vec2(i, i * stride % samples) + 0.5) / float(samples);
        sum += specular_lobe_sample(place.y, n_dot_v, xi);
    }
    lobe = sum / float(samples);
}
