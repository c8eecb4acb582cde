// SPDX-License-Identifier: MIT
#pragma once

#include "shared/scene.h"

SHARED_BEGIN

/// How a picture goes on beyond its edges.
const float picture_repeat = 0.0f;
const float picture_mirror = 1.0f;
const float picture_clamp = 2.0f;

/// What a material reads from pictures, all at one place of them; v runs down, as in glTF.
struct PictureParams {
    uvec4 layers;  ///< x: base colour, y: emission, in the array of colours; z: roughness (green) and metallic (blue), in that of data; or no_texture; w: unused
    vec4 axes;     ///< columns of the matrix from uv to the place
    vec4 place;    ///< xy: what is added to it; z, w: wrap along u and v
    vec4 alpha;    ///< x: factor; y: least that is shown, 0: all is, below 0: alpha is the share of light that is stopped; z: half a texel; w: unused
};

/// Where in its pictures a point lies, before they end.
SHARED_FN vec2 picture_place(PictureParams params, vec2 uv) {
    return vec2(params.axes.x, params.axes.y) * uv.x + vec2(params.axes.z, params.axes.w) * uv.y + vec2(params.place.x, params.place.y);
}

/// A coordinate brought into the picture by repeating, mirroring or stopping at the middle of its last texel.
SHARED_FN float picture_wrapped(float at, float wrap, float half_texel) {
    if (wrap == picture_mirror) {
        float turn = at - 2.0f * floor(at * 0.5f);
        at = turn > 1.0f ? 2.0f - turn : turn;
    }
    return wrap == picture_repeat ? at : clamp(at, half_texel, 1.0f - half_texel);
}

/// The same of both coordinates of a material's pictures.
SHARED_FN vec2 picture_inside(PictureParams params, vec2 place) {
    return vec2(picture_wrapped(place.x, params.place.z, params.alpha.z), picture_wrapped(place.y, params.place.w, params.alpha.z));
}

/// A material with what its pictures say at a point; white where it has none of a kind.
SHARED_FN MaterialParams pictured_material(MaterialParams material, vec3 colour, vec3 emission, vec3 data) {
    material.base_colour = vec4(vec3(material.base_colour) * colour, material.base_colour.w * data.y);
    material.emission = vec4(vec3(material.emission) * emission, material.emission.w * data.z);
    return material;
}

/// The share of light that a point stops: 0 or 1, or what lies between where the material is see-through.
SHARED_FN float picture_cover(PictureParams params, float alpha) {
    if (params.alpha.y == 0.0f) { return 1.0f; }
    if (params.alpha.y > 0.0f) { return alpha < params.alpha.y ? 0.0f : 1.0f; }
    return alpha;
}

SHARED_END
