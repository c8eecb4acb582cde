// SPDX-License-Identifier: MIT
#include "shared/frame.h"
#include "shared/tonemap.h"

layout(std140) uniform Frame { FrameParams frame; };
uniform sampler2D hdr;

layout(location = 0) out vec4 ldr;  // rgb: sRGB-encoded; a: luma, for anti-aliasing

void main() {
    vec3 shown = display_from_radiance(texelFetch(hdr, ivec2(gl_FragCoord.xy), 0).rgb, frame.ray_forward.w);
    ldr = vec4(shown, dot(shown, vec3(0.299, 0.587, 0.114)));
}
