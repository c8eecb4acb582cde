// SPDX-License-Identifier: MIT
// Packs all layers' texels into one array, in order.
#include "shared/rsm_texel.h"
#include "shared/rsm.h"

layout(local_size_x = 64) in;
#include "lib/linear_index.glsl"
uniform sampler2DArray rsm_position;
uniform sampler2DArray rsm_flux;
layout(std430) writeonly buffer Texels { RsmPackedTexel texels[]; };

void main() {
    uint size = uint(textureSize(rsm_position, 0).x);
    uint index = linear_index();
    if (index >= uint(texels.length())) { return; }
    uint within = index % (size * size);
    ivec3 at = ivec3(within % size, within / size, index / (size * size));
    vec4 position = texelFetch(rsm_position, at, 0);
    vec4 flux = texelFetch(rsm_flux, at, 0);
    texels[index].position = vec4(position.xyz, flux.a);
    texels[index].light = vec4(flux.rgb, position.w);
}
