// SPDX-License-Identifier: MIT
// Lists, for each row of the picture, the pixels that must gather for themselves.
#include "lib/row_list.glsl"

layout(local_size_x = 64) in;
uniform sampler2D refined;
layout(std430) writeonly buffer Pixels { uint pixels[]; };

void main() {
    ivec2 size = textureSize(refined, 0);
    uint row = gl_GlobalInvocationID.x;
    if (row >= uint(size.y)) { return; }
    uint count = 0u;
    for (int x = 0; x < size.x; ++x) {
        if (texelFetch(refined, ivec2(x, row), 0).r > 0.5) {
            pixels[row_list_entry(row, uint(size.x), count)] = uint(x);
            ++count;
        }
    }
    pixels[row_list_count(row, uint(size.x))] = count;
}
