// SPDX-License-Identifier: MIT
#pragma once

#include "shared/prelude.h"

SHARED_BEGIN

/// How water looks.
struct WaterParams {
    vec4 absorption;  ///< rgb: of light on its way through water, 1/m; w: time by which it ripples, s
    vec4 scattering;  ///< rgb: share of the light falling on deep water that comes back out of it; w: unused
    vec4 view;        ///< x: 1 where the camera is in water; y: 1 where the irradiance knows of the sky; z: pixel over distance; w: unused
};

const float water_index = 1.33f;  ///< of refraction

/// Schlick's Fresnel reflectance of a smooth water surface. `cosine` of the angle between normal and view, on whichever side
/// the view comes from; from below, past 48.8 degrees, all is reflected.
SHARED_FN float water_fresnel(float cosine, float from_below) {
    float ratio = (water_index - 1.0f) / (water_index + 1.0f);
    float r0 = ratio * ratio;
    float sine_squared = water_index * water_index * (1.0f - cosine * cosine);
    if (from_below > 0.0f && sine_squared >= 1.0f) { return 1.0f; }
    // Schlick's angle is the one in air.
    float in_air = from_below > 0.0f ? sqrt(1.0f - sine_squared) : cosine;
    float away = 1.0f - in_air;
    return r0 + (1.0f - r0) * away * away * away * away * away;
}

/// What is left of light after some metres of water (Beer-Lambert).
SHARED_FN vec3 water_transmission(vec3 absorption, float metres) { return exp2(absorption * (-1.442695f * metres)); }

/// Slope of the water's ripples at a point of its plane, in metres: five trains of waves that run at the speed of gravity
/// waves, in whole numbers of swings a minute, so that time may be cut to minutes. Waves shorter than `footprint`, m, are left
/// out. z: the variance of the slope that is left out.
SHARED_FN vec3 water_slope(vec2 at, float seconds, float footprint) {
    // Direction, wave number (1/m), swings a minute.
    vec4 trains[5];
    trains[0] = vec4(0.80f, 0.60f, 2.7f, 49.0f);
    trains[1] = vec4(-0.28f, 0.96f, 4.4f, 63.0f);
    trains[2] = vec4(0.96f, -0.28f, 7.3f, 81.0f);
    trains[3] = vec4(0.35f, 0.94f, 12.1f, 104.0f);
    trains[4] = vec4(-0.71f, 0.70f, 19.6f, 132.0f);
    const float steepness = 0.028f;
    vec3 sum = vec3(0.0f);
    for (int i = 0; i < 5; ++i) {
        vec2 direction = vec2(trains[i].x, trains[i].y);
        float phase = trains[i].z * dot(direction, at) - trains[i].w * 0.10471976f * seconds;
        float blur = 0.5f * trains[i].z * footprint;
        float kept = exp2(-blur * blur);
        vec2 slope = direction * (steepness * kept * cos(phase));
        sum += vec3(slope.x, slope.y, 0.5f * steepness * steepness * (1.0f - kept * kept));
    }
    return sum;
}

SHARED_END
