// SPDX-License-Identifier: MIT
// As pictured.vert, with what engine/core/mesh_data.h's PicturedVertex adds.
#include "lib/vertex.glsl"
#include "shared/view.h"

layout(location = 5) in vec2 vertex_second_uv;
layout(location = 6) in vec2 vertex_tangent;
layout(location = 7) in float vertex_hand;

layout(std140) uniform View { ViewParams view; };

out vec3 position_ws;
out vec3 normal_ws;
out vec2 uv;
out vec2 second_uv;
out vec4 tangent_ws;  // w: hand
out vec4 vertex_tint;
flat out uint material_index;

void main() {
    position_ws = position_in_world();
    normal_ws = normal_in_world();
    uv = vertex_uv;
    second_uv = vertex_second_uv;
    // Seen in a mirror, the other hand.
    float hand = draws[draw_index].first_material.y == 0u ? vertex_hand : -vertex_hand;
    tangent_ws = vec4(unit_or_zero(mat3(draws[draw_index].world_from_local) * octahedral_decode(vertex_tangent)), hand);
    vertex_tint = unpackUnorm4x8(vertex_colour);
    material_index = draws[draw_index].first_material.x + vertex_material;
    gl_Position = view.clip_from_world * vec4(position_ws, 1.0);
}
