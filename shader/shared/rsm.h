// SPDX-License-Identifier: MIT
#pragma once

#include "shared/constants.h"

SHARED_BEGIN

/// One texel of a reflective shadow map as a gather reads it. Flux 0 means that it holds nothing.
struct RsmTexel {
    vec4 position;  ///< xyz: m; w: patch area, m²
    vec4 normal;    ///< xyz: unit; w: index of its light's RSM layer
    vec4 flux;      ///< rgb: reflected flux, lumen; w: unused
};

/// The same in 32 bytes, for gathers in random order, which pay for each word. Flux in full floats: half floats end at 65,504
/// of whatever unit, and a lamp close to a surface lights it with more than any unit fit for moonlight holds.
struct RsmPackedTexel {
    vec4 position;  ///< xyz: m; w: packed normal (shared/rsm_texel.h)
    vec4 light;     ///< rgb: reflected flux, lumen; w: patch area, m²
};

/// Irradiance at a receiver from one texel, seen as a Lambertian disc of its patch's area (no occlusion):
/// E = (Φ/π) cos θ_p cos θ_x / (d² + A/π). Exact on the disc's axis, bounded everywhere, free of any length to guess.
SHARED_FN vec3 texel_irradiance(vec3 flux, vec3 texel_position, vec3 texel_normal, float area, vec3 position, vec3 normal) {
    vec3 offset = texel_position - position;
    float distance_squared = dot(offset, offset);
    float cos_texel = -dot(texel_normal, offset);
    float cos_receiver = dot(normal, offset);
    // Both cosines still carry a factor d, so d² divides them; at d = 0 the numerator is 0 as well.
    float facing = max(cos_texel, 0.0f) * max(cos_receiver, 0.0f) / max(distance_squared, 1e-30f);
    return flux * (facing / (shared_pi * distance_squared + area + 1e-30f));
}

/// Contribution of one polygon edge from a to b (relative to the receiver) to Lambert's form factor.
SHARED_FN float edge_form_factor(vec3 a, vec3 b, vec3 normal) {
    vec3 axis = cross(a, b);
    float sine = length(axis);
    float cosine = dot(a, b);
    if (sine < 1e-20f) { return 0.0f; }
    return dot(axis, normal) / sine * atan(sine, cosine);
}

/// Form factor from a point with `normal` to the parallelogram centre ± u ± v (relative to the point), clipped to the
/// receiver's horizon: Lambert's polygon formula (1760). 0 when the receiver stands behind it is the caller's test.
SHARED_FN float parallelogram_form_factor(vec3 centre, vec3 u, vec3 v, vec3 normal) {
    vec3 corners[4];
    corners[0] = centre - u - v;
    corners[1] = centre + u - v;
    corners[2] = centre + u + v;
    corners[3] = centre - u + v;
    float sum = 0.0f;
    vec3 last_point = vec3(0.0f);
    vec3 first_point = vec3(0.0f);
    float count = 0.0f;
    for (int i = 0; i < 4; ++i) {
        vec3 a = corners[i];
        vec3 b = corners[(i + 1) % 4];
        float height_a = dot(a, normal);
        float height_b = dot(b, normal);
        if (height_a <= 0.0f && height_b <= 0.0f) { continue; }
        if (height_a < 0.0f) { a = mix(a, b, height_a / (height_a - height_b)); }
        if (height_b < 0.0f) { b = mix(b, a, height_b / (height_b - height_a)); }
        // Where the horizon cut a piece away, an edge along the horizon closes the polygon; it lies in the plane of the
        // receiver, so its angle counts in full.
        if (count > 0.0f) { sum += edge_form_factor(last_point, a, normal); }
        if (count == 0.0f) { first_point = a; }
        sum += edge_form_factor(a, b, normal);
        last_point = b;
        count += 1.0f;
    }
    if (count > 0.0f) { sum += edge_form_factor(last_point, first_point, normal); }
    return abs(sum) / (2.0f * shared_pi);
}

SHARED_END
