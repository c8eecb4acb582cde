// SPDX-License-Identifier: MIT
#include "lib/vertex.glsl"
#include "shared/view.h"

layout(std140) uniform View { ViewParams view; };

out vec3 normal_ws;

void main() {
    normal_ws = normal_in_world();
    gl_Position = view.clip_from_world * vec4(position_in_world(), 1.0);
}
