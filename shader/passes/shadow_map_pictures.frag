// SPDX-License-Identifier: MIT
#include "lib/picture_colours.glsl"

in vec2 uv;
in vec4 vertex_tint;
flat in uint material_index;

void main() {
    PictureParams params = pictures_of(materials[material_index]);
    float alpha = picture_texel(picture_colours, params.layers.x, params.colour, coordinates_of(uv), params.alpha.z).a;
    discard_where_open(params, params.alpha.x * vertex_tint.a * alpha);
}
