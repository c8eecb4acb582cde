// SPDX-License-Identifier: MIT
// The picture without any water's surface, for a camera above it.
uniform sampler2D hdr;

layout(location = 0) out vec4 hdr_water;  // rgb: radiance, nit

void main() { hdr_water = texelFetch(hdr, ivec2(gl_FragCoord.xy), 0); }
