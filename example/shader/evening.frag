// SPDX-License-Identifier: MIT
// Radiance of an evening sky, from orange at the horizon to blue above, where there is no surface.
#include "shared/frame.h"

layout(std140) uniform Frame { FrameParams frame; };
uniform sampler2D depth;
uniform sampler2D picture;

in vec2 ndc;
layout(location = 0) out vec4 evening;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float rise = clamp(normalize(view_ray(frame, ndc)).y * 3.0, 0.0, 1.0);
    vec3 sky = mix(vec3(8000.0, 2400.0, 400.0), vec3(300.0, 700.0, 2500.0), rise);
    evening = texelFetch(depth, pixel, 0).r > 0.0 ? texelFetch(picture, pixel, 0) : vec4(sky, 1.0);
}
