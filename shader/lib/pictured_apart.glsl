// SPDX-License-Identifier: MIT
// A fragment's material where each of its pictures lies in its own way, one may tilt its normal, or it is unlit.
#include "lib/picture_colours.glsl"

uniform sampler2DArray picture_data;

in vec3 position_ws;
in vec3 normal_ws;
in vec2 uv;
in vec2 second_uv;
in vec4 tangent_ws;
in vec4 vertex_tint;
flat in uint material_index;

vec4 texel_of(sampler2DArray array, uint layer, uint second, PicturePlace place, float half_texel) {
    Coordinates one = coordinates_of(uv);
    Coordinates other = coordinates_of(second_uv);
    Coordinates at = Coordinates(second == 0u ? one.uv : other.uv, second == 0u ? one.right : other.right, second == 0u ? one.up : other.up);
    return picture_texel(array, layer, place, at, half_texel);
}

/// As in lib/pictured.glsl.
MaterialParams pictured_fragment() {
    MaterialParams material = materials[material_index];
    PictureParams params = pictures_of(material);
    vec4 colour = texel_of(picture_colours, params.layers.x, params.second.x, params.colour, params.alpha.z) * vertex_tint;
    vec3 emission = texel_of(picture_colours, params.layers.y, params.second.y, params.emission, params.alpha.z).rgb;
    vec3 data = texel_of(picture_data, params.layers.z, params.second.z, params.data, params.alpha.z).rgb;
    discard_where_open(params, params.alpha.x * colour.a);
    return unlit_material(pictured_material(material, colour.rgb, emission, data));
}

/// The fragment's normal with its normal texture; `flat_normal` is that of its vertices, unit.
vec3 relief_of_fragment(vec3 flat_normal) {
    PictureParams params = pictures_of(materials[material_index]);
    vec3 texel = texel_of(picture_data, params.layers.w, params.second.w, params.relief, params.alpha.z).rgb;
    return params.layers.w == no_texture ? flat_normal : relief_normal(flat_normal, tangent_ws, texel, params.alpha.w);
}
