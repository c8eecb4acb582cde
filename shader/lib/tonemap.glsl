// SPDX-License-Identifier: MIT
// What passes share that turn radiance into what a screen shows.
#include "shared/tonemap.h"

uniform sampler2D hdr;

layout(location = 0) out vec4 ldr;  // rgb: sRGB-encoded; a: luma, for anti-aliasing

vec4 tonemapped(float exposure) {
    vec3 shown = display_from_radiance(texelFetch(hdr, ivec2(gl_FragCoord.xy), 0).rgb, exposure);
    return vec4(shown, dot(shown, vec3(0.299, 0.587, 0.114)));
}
