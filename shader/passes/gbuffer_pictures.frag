// SPDX-License-Identifier: MIT
#include "lib/emission.glsl"
#include "lib/pictured.glsl"
#include "shared/octahedral.h"

layout(location = 0) out vec4 albedo;    // rgb: base colour
layout(location = 1) out vec2 normal;    // octahedral, 0..1
layout(location = 2) out vec4 material;  // roughness, metallic, specular
layout(location = 3) out vec4 emission;  // nit, as emission_texel keeps it

void main() {
    MaterialParams surface = pictured_fragment();
    albedo = vec4(surface.base_colour.rgb, 1.0);
    normal = octahedral_encode(unit_or_zero(normal_ws)) * 0.5 + 0.5;
    material = vec4(surface.base_colour.a, surface.emission.a, surface.specular.x, 0.0);
    emission = emission_texel(surface.emission.rgb);
}
