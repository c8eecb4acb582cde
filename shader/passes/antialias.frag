// SPDX-License-Identifier: MIT
// Smooths stair-steps after tonemapping: where luma jumps, walks along the edge to both of its ends and shifts the
// sample across it by how near the nearer end is (morphological anti-aliasing in the manner of FXAA 3, Lottes 2009).
uniform sampler2D ldr;

layout(location = 0) out vec4 final;

// Steps grow: an edge's far end matters less than its near one.
const float steps[4] = float[4](1.0, 1.0, 2.0, 4.0);
const float least_contrast = 0.06;

float luma(vec2 at) { return textureLod(ldr, at, 0.0).a; }

float neighbour_luma(ivec2 pixel) { return texelFetch(ldr, clamp(pixel, ivec2(0), textureSize(ldr, 0) - 1), 0).a; }

// Distance in pixels to where the edge's mean luma leaves its band, walking by `step`; and by how much it then differs.
vec2 edge_end(vec2 at, vec2 step, float edge_luma, float band) {
    float walked = 0.0;
    float difference = 0.0;
    for (int i = 0; i < 4; ++i) {
        walked += steps[i];
        difference = luma(at + step * walked) - edge_luma;
        if (abs(difference) >= band) { break; }
    }
    return vec2(walked, difference);
}

void main() {
    vec2 texel = 1.0 / vec2(textureSize(ldr, 0));
    vec2 at = gl_FragCoord.xy * texel;
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 centre = texelFetch(ldr, pixel, 0);
    float north = neighbour_luma(pixel + ivec2(0, 1));
    float south = neighbour_luma(pixel - ivec2(0, 1));
    float east = neighbour_luma(pixel + ivec2(1, 0));
    float west = neighbour_luma(pixel - ivec2(1, 0));
    float lowest = min(centre.a, min(min(north, south), min(east, west)));
    float highest = max(centre.a, max(max(north, south), max(east, west)));
    float contrast = highest - lowest;
    final = vec4(centre.rgb, 1.0);
    if (contrast < max(least_contrast, 0.125 * highest)) { return; }

    bool horizontal = abs(north + south - 2.0 * centre.a) >= abs(east + west - 2.0 * centre.a);
    vec2 across = horizontal ? vec2(0, texel.y) : vec2(texel.x, 0);
    vec2 along = horizontal ? vec2(texel.x, 0) : vec2(0, texel.y);
    float positive = (horizontal ? north : east) - centre.a;
    float negative = (horizontal ? south : west) - centre.a;
    float side = abs(positive) >= abs(negative) ? 1.0 : -1.0;
    float jump = side > 0.0 ? positive : negative;
    vec2 edge = at + across * 0.5 * side;
    float edge_luma = centre.a + 0.5 * jump;
    float band = 0.25 * abs(jump);
    vec2 forward = edge_end(edge, along, edge_luma, band);
    vec2 backward = edge_end(edge, -along, edge_luma, band);
    vec2 nearer = forward.x <= backward.x ? forward : backward;
    // Only the end where the edge turns towards this pixel's side covers part of the pixel.
    bool covered = (nearer.y < 0.0) != (centre.a - edge_luma < 0.0);
    float shift = covered ? 0.5 - nearer.x / (forward.x + backward.x) : 0.0;
    final = vec4(textureLod(ldr, at + across * side * max(shift, 0.0), 0.0).rgb, 1.0);
}
