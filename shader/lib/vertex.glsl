// SPDX-License-Identifier: MIT
// The attributes of engine/core/mesh_data.h's Vertex, and the row of DrawParams that this draw uses.
#include "shared/scene.h"
#include "shared/octahedral.h"

layout(location = 0) in vec3 vertex_position;
layout(location = 1) in uint vertex_normal;
layout(location = 2) in vec2 vertex_uv;
layout(location = 3) in uint vertex_material;
layout(location = 4) in uint vertex_colour;

layout(std430) readonly buffer Draws { DrawParams draws[]; };
uniform uint draw_index;

vec3 position_in_world() { return (draws[draw_index].world_from_local * vec4(vertex_position, 1.0)).xyz; }

vec3 normal_in_world() {
    vec3 normal = octahedral_decode(unpackSnorm2x16(vertex_normal));
    return unit_or_zero(mat3(draws[draw_index].normal_from_local) * normal);
}
