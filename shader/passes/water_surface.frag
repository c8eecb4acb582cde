// SPDX-License-Identifier: MIT
#include "shared/octahedral.h"

in vec3 normal_ws;

layout(location = 0) out vec2 water_normal;  // octahedral, 0..1; out of the water

void main() { water_normal = octahedral_encode(unit_or_zero(normal_ws)) * 0.5 + 0.5; }
