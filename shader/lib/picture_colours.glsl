// SPDX-License-Identifier: MIT
// Base colour and alpha of a fragment whose material reads pictures.
#include "lib/materials.glsl"
#include "shared/pictures.h"

layout(std430) readonly buffer Pictures { PictureParams pictures[]; };
uniform sampler2DArray picture_colours;

PictureParams pictures_of(MaterialParams material) { return pictures[material.texture.y - 1u]; }

/// Texture coordinates of a fragment, and how they change from pixel to pixel.
struct Coordinates {
    vec2 uv, right, up;
};
/// Of an input: fragments beside a triangle, which are there for derivatives alone, need not be able to read buffers.
Coordinates coordinates_of(vec2 uv) { return Coordinates(uv, dFdx(uv), dFdy(uv)); }

/// White where there is no layer. Derivatives are those of the place before the picture ends, so that its edges are not blurred.
vec4 picture_texel(sampler2DArray array, uint layer, PicturePlace place, Coordinates from, float half_texel) {
    mat2 axes = mat2(place.axes.xy, place.axes.zw);
    vec2 at = picture_inside(place, picture_place(place, from.uv), half_texel);
    vec4 texel = textureGrad(array, vec3(at, float(layer == no_texture ? 0u : layer)), axes * from.right, axes * from.up);
    return layer == no_texture ? vec4(1.0) : texel;
}

/// See-through surfaces stop light at some pixels and let it through at others, in a pattern that looks even (Jimenez 2014,
/// interleaved gradient noise).
void discard_where_open(PictureParams params, float alpha) {
    float pattern = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    if (picture_cover(params, alpha) <= pattern) discard;
}
