// SPDX-License-Identifier: MIT
// Light in water.
#include "lib/shadow.glsl"
#include "shared/frame.h"
#include "shared/water.h"

layout(std140) uniform Frame { FrameParams frame; };
layout(std140) uniform Water { WaterParams water; };
layout(std430) readonly buffer Lights { LightParams lights[]; };
uniform sampler2D depth;
uniform sampler2D irradiance;

const float farthest = 1e4;  // m

vec3 through(float metres) { return water_transmission(water.absorption.rgb, clamp(metres, 0.0, farthest)); }

vec2 ndc_of(ivec2 pixel) { return (vec2(pixel) + 0.5) / vec2(frame.ray_right.w, frame.ray_up.w) * 2.0 - 1.0; }

// Metres from the camera to what an image of depth holds at a pixel.
float distance_at(sampler2D image, ivec2 pixel) {
    float d = texelFetch(image, pixel, 0).r;
    return d > 0.0 ? length(view_ray(frame, ndc_of(pixel))) * view_distance(d, frame.camera_position.w) : farthest;
}

// How much of the sky arrives here, where that is known; a cave's water mirrors none.
float sky_share(ivec2 pixel) {
    vec3 weights = vec3(0.2126, 0.7152, 0.0722);
    float arriving = dot(texelFetch(irradiance, min(pixel, textureSize(irradiance, 0) - 1), 0).rgb, weights);
    float sky = shared_pi * dot(frame.sky.rgb, weights);
    // Light that has not been gathered yet is black: nothing is known there.
    if (arriving <= 0.0) { return 1.0; }
    return mix(1.0, clamp(2.0 * arriving / max(sky, 1e-12), 0.0, 1.0), water.view.y);
}

// Radiance of water without a ground, from the light that falls on it.
vec3 body(vec3 position, float share) {
    vec3 up = vec3(0, 1, 0);
    vec3 sum = shared_pi * share * frame.sky.rgb;
    for (uint i = 0u; i < frame.counts.z; ++i) {
        Incident incident = incident_light(lights[i], position);
        sum += incident.irradiance.rgb * (max(incident.to_light.y, 0.0) * sun_visibility(lights[i], incident, position, up));
    }
    return sum * water.scattering.rgb / shared_pi;
}

vec3 seen_through(vec3 radiance, float metres, vec3 body_radiance) { return mix(body_radiance, radiance, through(metres)); }
