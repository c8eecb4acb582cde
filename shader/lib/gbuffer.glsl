// SPDX-License-Identifier: MIT
// Reading the G-buffer back: what a full-screen pass knows of its pixel.
#include "shared/brdf.h"
#include "shared/frame.h"
#include "shared/octahedral.h"

layout(std140) uniform Frame { FrameParams frame; };
uniform sampler2D depth;
uniform sampler2D normal;

struct Point {
    vec3 position;
    vec3 normal;
    float distance;  // along the view axis; negative where there is no surface
};

/// From the camera through the middle of a pixel, as far as 1 along the view axis.
vec3 ray_through(ivec2 pixel) { return view_ray(frame, (vec2(pixel) + 0.5) / vec2(frame.ray_right.w, frame.ray_up.w) * 2.0 - 1.0); }

/// Along the view axis; negative where there is no surface.
float distance_at(ivec2 pixel) {
    float d = texelFetch(depth, pixel, 0).r;
    return d > 0.0 ? view_distance(d, frame.camera_position.w) : -1.0;
}

vec3 normal_at(ivec2 pixel) { return octahedral_decode(texelFetch(normal, pixel, 0).rg * 2.0 - 1.0); }

Point point_at(ivec2 pixel) {
    Point point;
    point.distance = distance_at(pixel);
    point.position = frame.camera_position.xyz + ray_through(pixel) * max(point.distance, 0.0);
    point.normal = normal_at(pixel);
    return point;
}
