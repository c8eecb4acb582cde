// SPDX-License-Identifier: MIT
// Gathering a receiver's light from a disc of RSM texels round its own projection (Dachsbacher & Stamminger 2005).
#include "shared/rsm_texel.h"
#include "shared/lights.h"
#include "shared/rsm.h"
#include "shared/view.h"

layout(std140) uniform Gather { RsmGatherParams gather; };
layout(std430) readonly buffer Lights { LightParams lights[]; };
layout(std430) readonly buffer Texels { RsmPackedTexel texels[]; };

float pixel_turn(ivec2 pixel) {
    uint h = uint(pixel.x) * 0x9e3779b1u ^ uint(pixel.y) * 0x85ebca77u;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    return float((h ^ (h >> 13)) >> 8) / 16777216.0;
}

// Radii are uniform, so density falls with 1/r and each sample stands for 2π r_max² ξ / N of the map's area: with that
// weight the expected sum does not depend on radius or sample count, as long as the disc reaches all light.
vec3 gather_layer(LightParams light, uint layer, Point point, ivec2 pixel, uint samples) {
    float size = gather.map.x;
    float radius = gather.disc.y * size;
    vec4 clip = light.map_clip_from_world * vec4(point.position, 1.0);
    // A receiver beside or behind a cone projects nowhere useful; the map's middle is as good a centre as any.
    vec2 centre = clip.w > 1e-6 ? clamp(clip.xy / clip.w, vec2(-1.5), vec2(1.5)) : vec2(0.0);
    centre = (centre * 0.5 + 0.5) * size;
    const float golden = 2.39996322973;
    float turn = gather.disc.z * pixel_turn(pixel) * 2.0 * shared_pi;
    vec2 arm = vec2(cos(turn), sin(turn));
    mat2 golden_turn = mat2(cos(golden), sin(golden), -sin(golden), cos(golden));
    float inverse_count = 1.0 / float(max(samples, 1u));
    uint first = layer * uint(size) * uint(size);
    float weight_scale = 2.0 * shared_pi * radius * radius * inverse_count;
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < samples; ++i) {
        float xi = (float(i) + 0.5) * inverse_count;
        vec2 at = centre + arm * (xi * radius);
        arm = golden_turn * arm;
        bool inside = all(greaterThanEqual(at, vec2(0.0))) && all(lessThan(at, vec2(size)));
        ivec2 cell = clamp(ivec2(at), ivec2(0), ivec2(size) - 1);
        RsmPackedTexel texel = texels[first + uint(cell.y) * uint(size) + uint(cell.x)];
        float weight = inside ? xi : 0.0;
        sum += texel_irradiance(texel.light.rgb, texel.position.xyz, unpack_texel_normal(texel.position.w), texel.light.w, point.position, point.normal) * weight;
    }
    return sum * weight_scale;
}

// How many of all samples a light gets: a quarter is dealt evenly, the rest by what each light throws into its map, so that
// a lamp beside the sun takes few of the sun's. Another light makes each noisier, not the frame slower.
uint samples_of(LightParams light, uint samples) {
    float share = 0.25 / gather.map.y + 0.75 * light.cone.z;
    return light.kind.z == no_layer || samples == 0u ? 0u : max(uint(float(samples) * share + 0.5), 1u);
}

// All layers' light at a point; no samples, no light.
vec3 gather_disc(Point point, ivec2 pixel, uint samples) {
    vec3 sum = vec3(0.0);
    for (uint i = 0u; i < frame.counts.x; ++i) {
        LightParams light = lights[i];
        sum += gather_layer(light, light.kind.z, point, pixel, samples_of(light, samples));
    }
    return sum * gather.map.z;
}
