// SPDX-License-Identifier: MIT
// A sum of which only a share is done, scaled as if complete, times the method's strength.
#include "shared/view.h"

layout(std140) uniform Gather { RsmGatherParams gather; };
uniform sampler2D partial;

layout(location = 0) out vec4 irradiance;

void main() { irradiance = vec4(texelFetch(partial, ivec2(gl_FragCoord.xy), 0).rgb * (gather.map.z * gather.map.w), 1.0); }
