// SPDX-License-Identifier: MIT
#include "lib/emission.glsl"
#include "lib/pictured_apart.glsl"

layout(location = 0) out vec4 albedo;         // rgb: base colour
layout(location = 1) out vec2 normal;         // octahedral, 0..1
layout(location = 2) out vec4 material;       // roughness, metallic, specular
layout(location = 3) out vec4 emission;       // nit, as emission_texel keeps it
layout(location = 4) out vec2 vertex_normal;  // octahedral, 0..1: without the normal texture

void main() {
    vec3 flat_normal = unit_or_zero(normal_ws);
    // Before anything is discarded: it takes derivatives.
    normal = octahedral_encode(relief_of_fragment(flat_normal)) * 0.5 + 0.5;
    MaterialParams surface = pictured_fragment();
    albedo = vec4(surface.base_colour.rgb, 1.0);
    material = vec4(surface.base_colour.a, surface.emission.a, surface.specular.x, 0.0);
    emission = emission_texel(surface.emission.rgb);
    vertex_normal = octahedral_encode(flat_normal) * 0.5 + 0.5;
}
