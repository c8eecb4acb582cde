// SPDX-License-Identifier: MIT
#pragma once

#include "shared/constants.h"

SHARED_BEGIN

/// One drawn mesh.
struct DrawParams {
    mat4 world_from_local;
    mat4 normal_from_local;  ///< cofactors of the linear part: turns normals right under any scale or mirror
    uvec4 first_material;    ///< x: row that Vertex.material counts from; y: 1 where world_from_local mirrors
};

/// One surface.
struct MaterialParams {
    vec4 base_colour;  ///< rgb linear; a: roughness
    vec4 emission;     ///< rgb nit; a: metallic
    vec4 specular;     ///< x: dielectric specular factor; y: where it is unlit, nit that the camera exposes as 1, else 0
    uvec4 texture;     ///< x: layer of the texture array, or no_texture; y: one more than its row of pictures, or 0
};

/// Base colour at a point; `texel` is the texture's colour there, which counts only where the material has one.
SHARED_FN vec3 surface_colour(MaterialParams material, vec3 texel, vec3 vertex_colour) {
    vec3 colour = vec3(material.base_colour) * vertex_colour;
    return material.texture.x == no_texture ? colour : colour * texel;
}

/// Emitted radiance at a point, nit: a glowing texture glows in its own colour.
SHARED_FN vec3 surface_emission(MaterialParams material, vec3 colour) {
    return material.texture.x == no_texture ? vec3(material.emission) : vec3(material.emission) * colour;
}

SHARED_END
