// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/math.h"

// The colour spaces of ꟻLIP. "Linear" is linear Rec. 709 with 1 as white; the white point is D65.

namespace sl {

/// sRGB-encoded to linear (IEC 61966-2-1).
vec3 linear_from_srgb(vec3 encoded);

/// YyCxCz: lightness-like Y, red-green Cx, blue-yellow Cz, all linear in the colour. White is (100, 0, 0), black
/// (−16, 0, 0).
vec3 opponent_from_linear(vec3 linear);
/// The inverse.
vec3 linear_from_opponent(vec3 opponent);

/// CIELAB with a and b multiplied by 0.01 · L: colour differences count less in the dark (Hunt 1952).
vec3 hunt_lab_from_linear(vec3 linear);

/// Distance of two CIELAB colours that stays sensible over large ones: |ΔL| + √(Δa² + Δb²) (Abasi et al. 2020).
float hyab(vec3 a, vec3 b);

}  // namespace sl
