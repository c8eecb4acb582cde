// SPDX-License-Identifier: MIT
#pragma once

#include "shared/prelude.h"

SHARED_BEGIN

/// Filmic curve: rational fit of the ACES reference transform (Narkowicz 2016). Exposed linear in, display linear out.
SHARED_FN vec3 filmic(vec3 exposed) {
    // The fit's own exposure makes mid-grey 0.5 brighter than EV100 means; 0.6 is its author's correction.
    vec3 x = max(exposed, vec3(0.0f)) * 0.6f;
    // Past this the curve is flat; without the bound, squares of large values would be infinite over infinite.
    x = min(x, vec3(1e4f));
    return clamp((x * (2.51f * x + 0.03f)) / (x * (2.43f * x + 0.59f) + 0.14f), vec3(0.0f), vec3(1.0f));
}

/// What the curve shows as a colour: its inverse, exposed linear, for 0 to 1.
SHARED_FN vec3 exposed_from_filmic(vec3 display) {
    vec3 y = clamp(display, vec3(0.0f), vec3(1.0f));
    vec3 a = 2.51f - 2.43f * y;
    vec3 b = 0.03f - 0.59f * y;
    return (sqrt(b * b + 0.56f * a * y) - b) / (1.2f * a);
}

/// Radiance, nit, of a surface that shows its colour whatever light there is; white: nit that the camera exposes as 1.
SHARED_FN vec3 unlit_radiance(vec3 colour, float white) { return exposed_from_filmic(colour) * white; }

/// The same of one channel.
SHARED_FN float srgb_encode_channel(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * pow(linear, 1.0f / 2.4f) - 0.055f;
}

/// Display linear to sRGB-encoded (IEC 61966-2-1).
SHARED_FN vec3 srgb_encode(vec3 linear) {
    return vec3(srgb_encode_channel(linear.x), srgb_encode_channel(linear.y), srgb_encode_channel(linear.z));
}

/// Radiance (nit) to what the screen shows. exposure = 1 / (1.2 · 2^EV100), as cameras define it (ISO 2720).
SHARED_FN vec3 display_from_radiance(vec3 radiance, float exposure) { return srgb_encode(filmic(radiance * exposure)); }

SHARED_END
