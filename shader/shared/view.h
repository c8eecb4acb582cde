// SPDX-License-Identifier: MIT
#pragma once

#include "shared/prelude.h"

SHARED_BEGIN

/// Where a geometry pass looks from.
struct ViewParams {
    mat4 clip_from_world;
    uvec4 light;  ///< x: index of the light whose map is drawn; y: map size, texels
};

/// What the gather passes of all RSM methods know; each reads the fields it needs.
struct RsmGatherParams {
    vec4 map;        ///< x: RSM size, texels; y: layers; z: strength; w: scale of a partial sum
    vec4 grid;       ///< rsm_grid: x: angle threshold, y: attenuation (1/m²), z: cutoff, w: step, texels
    vec4 disc;       ///< rsm_disc: x: samples, y: radius (map side), z: rotate (0 or 1), w: spacing of the low resolution, pixels
    vec4 tolerance;  ///< rsm_disc: x: plane distance over camera distance, y: cosine of normals
    uvec4 slice;     ///< x: first texel, y: stride, z: one past the last texel
};

SHARED_END
