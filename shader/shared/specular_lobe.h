// SPDX-License-Identifier: MIT
#pragma once

#include "shared/brdf.h"

SHARED_BEGIN

/// Texels along both sides of the image of lobes: to the right the root of n·v, 0 to 1 (lobes change fastest where it is
/// small); upwards the roughness, 0 to 1. Values lie in the middle of texels.
const uint specular_lobe_size = 32u;

/// One sample of the specular lobe's reflectance towards an eye: what is left of a ray that is reflected there (x), and the
/// same times Fresnel's (1 - v·h)⁵ (y). Their means over xi in [0, 1)² are the lobe's integrals without and with that term.
/// Microfacet normals as the eye sees them (Dupuy and Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps"), so
/// that only shadowing on light's side is left of the integrand (Heitz 2014).
SHARED_FN vec2 specular_lobe_sample(float roughness, float n_dot_v, vec2 xi) {
    float alpha = ggx_alpha(roughness), a2 = alpha * alpha;
    vec3 to_eye = vec3(sqrt(max(1.0f - n_dot_v * n_dot_v, 0.0f)), 0.0f, n_dot_v);
    vec3 stretched = normalize(vec3(alpha * to_eye.x, 0.0f, to_eye.z));
    float turn = 2.0f * shared_pi * xi.x, height = (1.0f - xi.y) * (1.0f + stretched.z) - stretched.z;
    float across = sqrt(max(1.0f - height * height, 0.0f));
    vec3 cap = vec3(across * cos(turn), across * sin(turn), height) + stretched;
    vec3 halfway = normalize(vec3(alpha * cap.x, alpha * cap.y, max(cap.z, 1e-6f)));
    float v_dot_h = clamp(dot(to_eye, halfway), 0.0f, 1.0f);
    float n_dot_l = 2.0f * v_dot_h * halfway.z - n_dot_v;
    if (n_dot_l <= 0.0f) { return vec2(0.0f); }
    float light_side = n_dot_v * sqrt(n_dot_l * n_dot_l * (1.0f - a2) + a2);
    float view_root = sqrt(n_dot_v * n_dot_v * (1.0f - a2) + a2);
    float left = n_dot_l * (n_dot_v + view_root) / max(light_side + n_dot_l * view_root, 1e-12f);
    float away = 1.0f - v_dot_h;
    return left * vec2(1.0f, away * away * away * away * away);
}

SHARED_END
