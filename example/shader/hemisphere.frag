// SPDX-License-Identifier: MIT
// Irradiance between two half spaces of even radiance L: a surface whose normal rises by y sees the share (1 + y) / 2 of the
// upper one, weighted by the cosine, and E = pi * (L_sky * (1 + y) / 2 + L_ground * (1 - y) / 2).
#include "hemisphere.h"
#include "shared/brdf.h"
#include "shared/octahedral.h"

layout(std140) uniform Hemisphere { HemisphereParams hemisphere; };
uniform sampler2D normal;

layout(location = 0) out vec4 irradiance;

void main() {
    vec3 up = octahedral_decode(texelFetch(normal, ivec2(gl_FragCoord.xy), 0).rg * 2.0 - 1.0);
    irradiance = vec4(shared_pi * mix(hemisphere.ground.rgb, hemisphere.sky.rgb, 0.5 + 0.5 * up.y), 1.0);
}
