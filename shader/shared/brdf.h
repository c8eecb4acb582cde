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

/// The share of light given back diffusely, before Fresnel's term takes its part.
SHARED_FN vec3 diffuse_albedo(Surface surface) { return vec3(surface.base_colour) * (1.0f - surface.normal.w); }

/// Reflectance of the specular part at grazing angles; 0: there is none.
SHARED_FN float specular_strength(Surface surface) { return mix(surface.specular.x, 1.0f, surface.normal.w); }

/// Reflectance of the specular part straight on.
SHARED_FN vec3 specular_f0(Surface surface) { return mix(vec3(0.04f * surface.specular.x), vec3(surface.base_colour), surface.normal.w); }

/// Mean of Fresnel's (1 - v·h)⁵ over directions of light weighted with their cosine: by so much the diffuse part loses more
/// than it does straight on. A fit to 4096 samples at each of 41 angles, off by less than 0.001.
SHARED_FN float grazing_of_diffuse(float n_dot_v) {
    float away = 1.0f - n_dot_v;
    return 0.028f * away * away * sqrt(away);
}
/// The same over views as well, weighted with theirs. By 400,000 samples.
const float mean_grazing_of_diffuse = 0.0037f;

/// Of light that comes evenly from everywhere, what the surface gives back towards an eye, or to all sides on average, as
/// `lobe` is of one or the other: xy: integrals of the specular lobe (specular_lobe.h), z: grazing_of_diffuse. Times
/// irradiance/π it is radiance: the split sum of Karis 2013, "Real Shading in Unreal Engine 4".
SHARED_FN vec3 albedo_in_even_light(Surface surface, vec3 lobe) {
    float specular = specular_strength(surface);
    vec3 diffuse = diffuse_albedo(surface);
    if (specular <= 0.0f) { return diffuse; }
    vec3 f0 = specular_f0(surface), rise = vec3(specular) - f0;
    return diffuse * (vec3(1.0f) - f0 - rise * lobe.z) + f0 * lobe.x + rise * lobe.y;
}

/// Width of the specular lobe. The smoothest keeps one, so that float can hold its height.
SHARED_FN float ggx_alpha(float roughness) { return max(roughness * roughness, 1e-3f); }

/// Trowbridge-Reitz distribution times height-correlated Smith visibility (Heitz 2014); alpha: ggx_alpha.
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
    float specular = specular_strength(surface);
    vec3 diffuse = diffuse_albedo(surface) / shared_pi;
    if (specular <= 0.0f) { return diffuse * n_dot_l; }
    vec3 half_sum = to_light + to_eye;
    vec3 halfway = half_sum / max(length(half_sum), 1e-6f);
    float n_dot_v = max(dot(normal, to_eye), 1e-4f);
    float v_dot_h = clamp(dot(to_eye, halfway), 0.0f, 1.0f);
    float alpha = ggx_alpha(surface.base_colour.w);
    vec3 f0 = specular_f0(surface);
    float away = 1.0f - v_dot_h;
    float grazing = away * away * away * away * away;
    vec3 fresnel = f0 + (vec3(specular) - f0) * grazing;
    float lobe = ggx_specular(alpha, normal, halfway, n_dot_l, n_dot_v);
    return (diffuse * (vec3(1.0f) - fresnel) + fresnel * lobe) * n_dot_l;
}

SHARED_END
