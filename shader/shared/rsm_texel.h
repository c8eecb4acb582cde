// SPDX-License-Identifier: MIT
#pragma once

#include "shared/octahedral.h"

SHARED_BEGIN

/// A texel's normal as one float: two 12-bit octahedral coordinates make an integer that a float holds exactly, so that a
/// texel is two fetches. 4094 steps, not 4095: axis directions then come back exact.
SHARED_FN float pack_texel_normal(vec3 normal) {
    vec2 steps = round((octahedral_encode(normal) * 0.5f + 0.5f) * 4094.0f);
    return steps.x * 4096.0f + steps.y;
}

/// The inverse, of length 1.
SHARED_FN vec3 unpack_texel_normal(float packed_normal) {
    float x = floor(packed_normal / 4096.0f);
    return octahedral_decode(vec2(x, packed_normal - x * 4096.0f) / 4094.0f * 2.0f - 1.0f);
}

SHARED_END
