// SPDX-License-Identifier: MIT
#include "lib/tonemap.glsl"
#include "shared/frame.h"

layout(std140) uniform Frame { FrameParams frame; };

void main() { ldr = tonemapped(frame.ray_forward.w); }
