// SPDX-License-Identifier: MIT
// As tonemap.frag, with the exposure that exposure.comp has found.
#include "lib/tonemap.glsl"
#include "shared/exposure.h"

layout(std430) readonly buffer Exposure { float ev; };

void main() { ldr = tonemapped(exposure_of(ev)); }
