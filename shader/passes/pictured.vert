// SPDX-License-Identifier: MIT
#include "lib/vertex.glsl"
#include "shared/view.h"

layout(std140) uniform View { ViewParams view; };

out vec3 position_ws;
out vec3 normal_ws;
out vec2 uv;
out vec4 vertex_tint;
flat out uint material_index;

void main() {
    position_ws = position_in_world();
    normal_ws = normal_in_world();
    uv = vertex_uv;
    vertex_tint = unpackUnorm4x8(vertex_colour);
    material_index = draws[draw_index].first_material.x + vertex_material;
    gl_Position = view.clip_from_world * vec4(position_ws, 1.0);
}
