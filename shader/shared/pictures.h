// SPDX-License-Identifier: MIT
#pragma once

#include "shared/octahedral.h"
#include "shared/scene.h"
#include "shared/tonemap.h"

SHARED_BEGIN

/// How a picture goes on beyond its edges.
const float picture_repeat = 0.0f;
const float picture_mirror = 1.0f;
const float picture_clamp = 2.0f;

/// How a picture lies on a surface; v runs down, as in glTF.
struct PicturePlace {
    vec4 axes;    ///< columns of the matrix from uv to the place
    vec4 offset;  ///< xy: what is added to it; z, w: wrap along u and v
};

/// What a material reads from pictures. Where they lie together, all lie as `colour` does.
struct PictureParams {
    uvec4 layers;   ///< x: base colour, y: emission, in the array of colours; z: roughness (green) and metallic (blue), w: normals, in that of data; or no_texture
    uvec4 second;   ///< of each of these: 1 where it reads the second texture coordinates
    PicturePlace colour, emission, data, relief;
    vec4 alpha;     ///< x: factor; y: least that is shown, 0: all is, below 0: alpha is the share of light that is stopped; z: half a texel; w: factor on the lean of normals
};

/// Where in its picture a point lies, before it ends.
SHARED_FN vec2 picture_place(PicturePlace place, vec2 uv) {
    return vec2(place.axes.x, place.axes.y) * uv.x + vec2(place.axes.z, place.axes.w) * uv.y + vec2(place.offset.x, place.offset.y);
}

/// A coordinate brought into the picture by repeating, mirroring or stopping at the middle of its last texel.
SHARED_FN float picture_wrapped(float at, float wrap, float half_texel) {
    if (wrap == picture_mirror) {
        float turn = at - 2.0f * floor(at * 0.5f);
        at = turn > 1.0f ? 2.0f - turn : turn;
    }
    return wrap == picture_repeat ? at : clamp(at, half_texel, 1.0f - half_texel);
}

/// The same of both coordinates in a picture.
SHARED_FN vec2 picture_inside(PicturePlace place, vec2 at, float half_texel) {
    return vec2(picture_wrapped(at.x, place.offset.z, half_texel), picture_wrapped(at.y, place.offset.w, half_texel));
}

/// A material with what its pictures say at a point; white where it has none of a kind.
SHARED_FN MaterialParams pictured_material(MaterialParams material, vec3 colour, vec3 emission, vec3 data) {
    material.base_colour = vec4(vec3(material.base_colour) * colour, material.base_colour.w * data.y);
    material.emission = vec4(vec3(material.emission) * emission, material.emission.w * data.z);
    return material;
}

/// A material as light and the camera meet it: one that is unlit is black and gives off its colour, which only the camera may see.
SHARED_FN MaterialParams unlit_material(MaterialParams material) {
    if (material.specular.y <= 0.0f) { return material; }
    material.emission = vec4(unlit_radiance(vec3(material.base_colour), material.specular.y), 0.0f);
    material.base_colour = vec4(0.0f, 0.0f, 0.0f, 1.0f);
    material.specular = vec4(0.0f, material.specular.y, 0.0f, 0.0f);
    return material;
}

/// The normal that a texel of a normal texture asks for; `normal` is the vertices'. tangent: where the texture's right lies (xyz),
/// and the sign of cross(normal, tangent) where its top lies (w). lean: factor on what is not along the normal.
SHARED_FN vec3 relief_normal(vec3 normal, vec4 tangent, vec3 texel, float lean) {
    vec3 right = unit_or_zero(vec3(tangent) - normal * dot(normal, vec3(tangent)));
    vec3 top = cross(normal, right) * (tangent.w < 0.0f ? -1.0f : 1.0f);
    vec3 asked = texel * 2.0f - vec3(1.0f);
    vec3 tilted = right * (asked.x * lean) + top * (asked.y * lean) + normal * asked.z;
    return dot(tilted, tilted) > 0.0f ? normalize(tilted) : normal;
}

/// The share of light that a point stops: 0 or 1, or what lies between where the material is see-through.
SHARED_FN float picture_cover(PictureParams params, float alpha) {
    if (params.alpha.y == 0.0f) { return 1.0f; }
    if (params.alpha.y > 0.0f) { return alpha < params.alpha.y ? 0.0f : 1.0f; }
    return alpha;
}

SHARED_END
