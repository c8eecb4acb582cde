// SPDX-License-Identifier: MIT
#include "lib/direct_light.glsl"

layout(location = 0) out vec4 direct;  // rgb: radiance, nit

float share_from(vec3 to_light, vec3 facing) { return 1.0; }

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    Point point = point_at(pixel);
    direct = vec4(directly_lit(pixel, point, point.normal), 1.0);
}
