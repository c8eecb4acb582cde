// SPDX-License-Identifier: MIT
// A fragment's material: base colour from table, texture and vertex.
#include "lib/materials.glsl"

uniform sampler2DArray block_textures;

vec3 base_colour_of(MaterialParams material, vec2 uv, vec3 vertex_colour) {
    // Derivatives are taken outside the branch, where all four fragments of a quad take part.
    vec4 texel = textureGrad(block_textures, vec3(uv, float(material.texture.x == no_texture ? 0u : material.texture.x)), dFdx(uv), dFdy(uv));
    return surface_colour(material, texel.rgb, vertex_colour);
}
