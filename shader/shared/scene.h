// SPDX-License-Identifier: MIT
#pragma once

#include "shared/constants.h"

SHARED_BEGIN

/// One drawn mesh.
struct DrawParams {
    mat4 world_from_local;
    mat4 normal_from_local;  ///< cofactors of the linear part: turns normals right under any scale or mirror
    uvec4 first_material;    ///< x: row that Vertex.material counts from
};

/// One surface.
struct MaterialParams {
    vec4 base_colour;  ///< rgb linear; a: roughness
    vec4 emission;     ///< rgb nit; a: metallic
    vec4 specular;     ///< x: dielectric specular factor
    uvec4 texture;     ///< x: layer of the texture array, or no_texture
};

SHARED_END
