// SPDX-License-Identifier: MIT
// Of scenes in which some surfaces are not matte.
#include "lib/composed.glsl"
#include "shared/specular_lobe.h"

uniform sampler2D specular_lobe;

vec3 lobe_towards_eye(Surface surface, ivec2 pixel, vec3 to_eye) {
    float n_dot_v = clamp(dot(normal_at(pixel), to_eye), 0.0, 1.0);
    vec2 place = vec2(sqrt(n_dot_v), surface.base_colour.a);
    vec2 lobe = textureLod(specular_lobe, (place * float(specular_lobe_size - 1u) + 0.5) / float(specular_lobe_size), 0.0).rg;
    return vec3(lobe, grazing_of_diffuse(n_dot_v));
}
