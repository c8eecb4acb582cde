// SPDX-License-Identifier: MIT
// As direct_light.frag, where normal textures tilt normals: shadows are looked up from the surface as it lies.
#include "lib/direct_light.glsl"

uniform sampler2D vertex_normal;

layout(location = 0) out vec4 direct;  // rgb: radiance, nit

/// Light from behind the surface does not shine through it onto what leans towards the light; see SurfacePoint::faces.
float share_from(vec3 to_light, vec3 facing) { return dot(facing, to_light) > 0.0 ? 1.0 : 0.0; }

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 facing = octahedral_decode(texelFetch(vertex_normal, pixel, 0).rg * 2.0 - 1.0);
    direct = vec4(directly_lit(pixel, point_at(pixel), facing), 1.0);
}
