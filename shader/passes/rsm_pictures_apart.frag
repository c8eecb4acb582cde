// SPDX-License-Identifier: MIT
#include "lib/pictured_apart.glsl"
#include "lib/rsm_texel.glsl"

void main() {
    MaterialParams surface = pictured_fragment();
    write_rsm_texel(position_ws, unit_or_zero(normal_ws), surface.base_colour.rgb * (1.0 - surface.emission.a));
}
