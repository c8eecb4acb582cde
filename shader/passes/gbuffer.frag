// SPDX-License-Identifier: MIT
#include "lib/emission.glsl"
#include "lib/surface.glsl"
#include "shared/octahedral.h"

in vec3 normal_ws;
in vec2 uv;
in vec3 vertex_tint;
flat in uint material_index;

layout(location = 0) out vec4 albedo;    // rgb: base colour
layout(location = 1) out vec2 normal;    // octahedral, 0..1
layout(location = 2) out vec4 material;  // roughness, metallic, specular
layout(location = 3) out vec4 emission;  // nit, as emission_texel keeps it

void main() {
    MaterialParams surface = materials[material_index];
    albedo = vec4(base_colour_of(surface, uv, vertex_tint), 1.0);
    normal = octahedral_encode(unit_or_zero(normal_ws)) * 0.5 + 0.5;
    material = vec4(surface.base_colour.a, surface.emission.a, surface.specular.x, 0.0);
    emission = emission_texel(surface_emission(surface, albedo.rgb));
}
