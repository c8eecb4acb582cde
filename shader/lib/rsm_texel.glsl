// SPDX-License-Identifier: MIT
// Turns each texel that a light sees into a small light: where it is, which way it faces, and the flux it reflects.
#include "shared/rsm_texel.h"
#include "shared/lights.h"
#include "shared/view.h"

layout(std140) uniform View { ViewParams view; };
layout(std430) readonly buffer Lights { LightParams lights[]; };

layout(location = 0) out vec4 rsm_position;  // xyz: m; w: patch area, m²
layout(location = 1) out vec4 rsm_flux;      // rgb: lumen; a: packed normal

void write_rsm_texel(vec3 position, vec3 normal, vec3 diffuse) {
    LightParams light = lights[view.light.x];
    Incident incident = incident_light(light, position);
    // Area across the light's rays: constant for parallel light; for a cone the texel's solid angle, which shrinks with
    // cos³ off the axis, times distance squared.
    float across = light.intensity.w / float(view.light.y * view.light.y);
    if (light.kind.x != light_directional) {
        float cos_axis = dot(-incident.to_light.xyz, light.direction.xyz);
        across *= cos_axis * cos_axis * cos_axis * incident.to_light.w * incident.to_light.w;
    }
    float cos_surface = dot(normal, incident.to_light.xyz);
    vec3 flux = cos_surface > 0.0 ? diffuse * incident.irradiance.rgb * across : vec3(0.0);
    rsm_position = vec4(position, across / max(cos_surface, 1e-3));
    rsm_flux = vec4(flux, pack_texel_normal(normal));
}
