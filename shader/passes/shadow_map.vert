// SPDX-License-Identifier: MIT
#include "lib/vertex.glsl"
#include "shared/view.h"

layout(std140) uniform View { ViewParams view; };

void main() { gl_Position = view.clip_from_world * vec4(position_in_world(), 1.0); }
