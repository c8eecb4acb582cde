// SPDX-License-Identifier: MIT
#include "lib/rsm_texel.glsl"
#include "lib/surface.glsl"

in vec3 position_ws;
in vec3 normal_ws;
in vec2 uv;
in vec3 vertex_tint;
flat in uint material_index;

void main() {
    MaterialParams surface = materials[material_index];
    vec3 diffuse = base_colour_of(surface, uv, vertex_tint) * (1.0 - surface.emission.a);
    write_rsm_texel(position_ws, unit_or_zero(normal_ws), diffuse);
}
