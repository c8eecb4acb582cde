// SPDX-License-Identifier: MIT
// A texel's normal as one float: two 12-bit octahedral coordinates make an integer that a float holds exactly, so that a
// texel is two fetches. 4094 steps, not 4095: axis directions then come back exact.
#include "shared/octahedral.h"

float pack_texel_normal(vec3 normal) {
    vec2 steps = round((octahedral_encode(normal) * 0.5 + 0.5) * 4094.0);
    return steps.x * 4096.0 + steps.y;
}

vec3 unpack_texel_normal(float packed_normal) {
    float x = floor(packed_normal / 4096.0);
    return octahedral_decode(vec2(x, packed_normal - x * 4096.0) / 4094.0 * 2.0 - 1.0);
}
