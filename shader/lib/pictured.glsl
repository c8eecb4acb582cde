// SPDX-License-Identifier: MIT
// A fragment's material where it reads pictures that lie together.
#include "lib/picture_colours.glsl"

uniform sampler2DArray picture_data;

in vec3 position_ws;
in vec3 normal_ws;
in vec2 uv;
in vec4 vertex_tint;
flat in uint material_index;

/// The fragment's material with its pictures and its vertex's tint; discards what is open.
MaterialParams pictured_fragment() {
    MaterialParams material = materials[material_index];
    PictureParams params = pictures_of(material);
    Coordinates at = coordinates_of(uv);
    vec4 colour = picture_texel(picture_colours, params.layers.x, params.colour, at, params.alpha.z) * vertex_tint;
    vec3 emission = picture_texel(picture_colours, params.layers.y, params.colour, at, params.alpha.z).rgb;
    vec3 data = picture_texel(picture_data, params.layers.z, params.colour, at, params.alpha.z).rgb;
    discard_where_open(params, params.alpha.x * colour.a);
    return pictured_material(material, colour.rgb, emission, data);
}
