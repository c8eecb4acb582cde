// SPDX-License-Identifier: MIT
#pragma once

#include "shared/prelude.h"

SHARED_BEGIN

/// How a camera's exposure follows the picture.
struct ExposureParams {
    vec4 adapt;  ///< x: share of the way that this frame goes; y: EV that stays as it is; z, w: least and greatest EV
};

/// Points of a picture that its exposure is measured at, along each side.
const uint metered_points = 48u;

/// How much a point counts, at 0 to 1 of the picture's sides: the middle most. What is black as night says nothing, and what is
/// no number would stay for ever.
SHARED_FN float metering_weight(vec2 at, float luminance) {
    vec2 off = at - vec2(0.5f);
    return luminance > 1e-6f && luminance < 1e9f ? exp2(-8.0f * dot(off, off)) : 0.0f;
}

/// 1 / (1.2 · 2^EV100), as cameras define it (ISO 2720).
SHARED_FN float exposure_of(float ev100) { return 1.0f / (1.2f * exp2(ev100)); }

/// The EV at which reflected-light meters expose a mean luminance, nit (ISO 2720, K = 12.5: log2(100 / K) = 3), less what the
/// filmic curve darkens mid-grey; and a fifth less far from what stays as it is: dark rooms are seen, and seen to be dark.
SHARED_FN float adapted_ev(float log2_luminance, ExposureParams params) {
    float metered = log2_luminance + 2.3f;
    return clamp(params.adapt.y + 0.8f * (metered - params.adapt.y), params.adapt.z, params.adapt.w);
}

SHARED_END
