// SPDX-License-Identifier: MIT
// Emission in an image of half floats, which end at 65504: a lamp's face and, in daylight, white without light are brighter.

/// Radiance, nit; a: how often it was halved to fit.
vec4 emission_texel(vec3 radiance) {
    vec3 finite = min(radiance, vec3(1e30));
    float halved = max(ceil(log2(max(finite.r, max(finite.g, finite.b)) / 65504.0)), 0.0);
    return vec4(finite * exp2(-halved), halved);
}

/// The radiance again, nit.
vec3 emission_of(vec4 texel) { return texel.rgb * exp2(texel.a); }
