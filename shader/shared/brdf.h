// SPDX-License-Identifier: MIT
#pragma once

#include "shared/constants.h"

SHARED_BEGIN

/// A surface point's reflectance: glTF 2.0's metallic-roughness model.
struct Surface {
    vec4 base_colour;  ///< rgb linear; a: roughness
    vec4 normal;       ///< xyz: unit; w: metallic
    vec4 specular;     ///< x: dielectric specular factor
};

/// The share of light given back diffusely; what indirect irradiance is multiplied with.
SHARED_FN vec3 diffuse_albedo(Surface surface) { return vec3(surface.base_colour) * (1.0f - surface.normal.w); }

/// Trowbridge-Reitz distribution times height-correlated Smith visibility (Heitz 2014); alpha = roughness².
SHARED_FN float ggx_specular(float alpha, vec3 normal, vec3 halfway, float n_dot_l, float n_dot_v) {
    float a2 = alpha * alpha;
    // sin² from the cross product: 1 - cos² would lose all its digits near the peak of a smooth surface.
    vec3 sine = cross(normal, halfway);
    float n_dot_h = dot(normal, halfway);
    float spread = dot(sine, sine) + a2 * n_dot_h * n_dot_h;
    float distribution = a2 / (shared_pi * spread * spread);
    float light_side = n_dot_v * sqrt(n_dot_l * n_dot_l * (1.0f - a2) + a2);
    float view_side = n_dot_l * sqrt(n_dot_v * n_dot_v * (1.0f - a2) + a2);
    return distribution * 0.5f / max(light_side + view_side, 1e-7f);
}

/// f_r · cos θ_l: Lambert under a Schlick-weighted GGX coat for dielectrics, GGX alone for metal (glTF 2.0, appendix B).
SHARED_FN vec3 reflected(Surface surface, vec3 to_light, vec3 to_eye) {
    vec3 normal = vec3(surface.normal);
    float n_dot_l = dot(normal, to_light);
    if (n_dot_l <= 0.0f) { return vec3(0.0f); }
    float metallic = surface.normal.w;
    float specular = mix(surface.specular.x, 1.0f, metallic);
    vec3 diffuse = diffuse_albedo(surface) / shared_pi;
    if (specular <= 0.0f) { return diffuse * n_dot_l; }
    vec3 half_sum = to_light + to_eye;
    vec3 halfway = half_sum / max(length(half_sum), 1e-6f);
    float n_dot_v = max(dot(normal, to_eye), 1e-4f);
    float v_dot_h = clamp(dot(to_eye, halfway), 0.0f, 1.0f);
    float alpha = max(surface.base_colour.w * surface.base_colour.w, 1e-3f);
    vec3 f0 = mix(vec3(0.04f * specular), vec3(surface.base_colour), metallic);
    float away = 1.0f - v_dot_h;
    float grazing = away * away * away * away * away;
    vec3 fresnel = f0 + (vec3(specular) - f0) * grazing;
    float lobe = ggx_specular(alpha, normal, halfway, n_dot_l, n_dot_v);
    return (diffuse * (vec3(1.0f) - fresnel) + fresnel * lobe) * n_dot_l;
}

SHARED_END
