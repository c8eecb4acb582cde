// SPDX-License-Identifier: MIT
// Normals once more, where one image is about to get others.
uniform sampler2D normal;

layout(location = 0) out vec2 vertex_normal;

void main() { vertex_normal = texelFetch(normal, ivec2(gl_FragCoord.xy), 0).rg; }
