// SPDX-License-Identifier: MIT
// Of scenes whose surfaces are all matte.
#include "lib/composed.glsl"

vec3 lobe_towards_eye(Surface surface, ivec2 pixel, vec3 to_eye) { return vec3(0.0); }
