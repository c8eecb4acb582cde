// SPDX-License-Identifier: MIT
// Copies all layers' texels into one array, in order.
#include "shared/rsm_texel.h"
#include "shared/rsm.h"

layout(local_size_x = 64) in;
#include "lib/linear_index.glsl"
uniform sampler2DArray rsm_position;
uniform sampler2DArray rsm_flux;
layout(std430) writeonly buffer Texels { RsmTexel texels[]; };

void main() {
    uint size = uint(textureSize(rsm_position, 0).x);
    uint index = linear_index();
    if (index >= uint(texels.length())) { return; }
    uint layer = index / (size * size);
    uint within = index % (size * size);
    ivec3 at = ivec3(within % size, within / size, layer);
    vec4 flux = texelFetch(rsm_flux, at, 0);
    texels[index].position = texelFetch(rsm_position, at, 0);
    texels[index].normal = vec4(unpack_texel_normal(flux.a), float(layer));
    texels[index].flux = vec4(flux.rgb, 0.0);
}
