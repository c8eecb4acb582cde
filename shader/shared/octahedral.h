// SPDX-License-Identifier: MIT
#pragma once

#include "shared/prelude.h"

SHARED_BEGIN

/// The vector at length 1. One without a length has no direction: it stays zero, where normalize would make NaN of it.
/// Files bring such normals, normals that cancel within a triangle do, and draws that are scaled flat.
SHARED_FN vec3 unit_or_zero(vec3 v) {
    if (!(dot(v, v) > 0.0f)) { return vec3(0.0f); }
    return normalize(v);
}

/// A unit vector as a point of the square [-1, 1]² (Cigolle et al. 2014).
SHARED_FN vec2 octahedral_encode(vec3 v) {
    vec3 folded = v / max(abs(v.x) + abs(v.y) + abs(v.z), 1e-20f);
    vec2 upper = vec2(folded.x, folded.y);
    if (folded.z >= 0.0f) { return upper; }
    vec2 signs = vec2(upper.x >= 0.0f ? 1.0f : -1.0f, upper.y >= 0.0f ? 1.0f : -1.0f);
    return (vec2(1.0f) - vec2(abs(upper.y), abs(upper.x))) * signs;
}

/// The inverse: a unit vector of a point in [-1, 1]².
SHARED_FN vec3 octahedral_decode(vec2 p) {
    vec3 v = vec3(p.x, p.y, 1.0f - abs(p.x) - abs(p.y));
    float below = max(-v.z, 0.0f);
    v.x += v.x >= 0.0f ? -below : below;
    v.y += v.y >= 0.0f ? -below : below;
    return normalize(v);
}

SHARED_END
