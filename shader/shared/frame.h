// SPDX-License-Identifier: MIT
#pragma once

#include "shared/prelude.h"

SHARED_BEGIN

/// What every pass may know of the frame. World space is relative to the scene's origin, in metres.
struct FrameParams {
    mat4 clip_from_world;
    vec4 camera_position;  ///< xyz; w: near, m
    vec4 ray_forward;      ///< xyz: unit vector out of the camera; w: exposure (multiplies nit)
    vec4 ray_right;        ///< xyz: to the right edge at distance 1; w: width, pixels
    vec4 ray_up;           ///< xyz: to the upper edge at distance 1; w: height, pixels
    vec4 sky;              ///< rgb: radiance, nit; w: extinction of the air, 1/m
    uvec4 counts;          ///< x: lights; y: frame index; z: directional lights; w: directional and spot lights. In this order.
};

/// Distance along the view axis of a reversed, infinite depth; the background (0) is infinitely far.
SHARED_FN float view_distance(float depth, float near) { return near / depth; }

/// The vector from the camera to a pixel's surface. ndc: -1..1; distance: view_distance.
SHARED_FN vec3 view_ray(FrameParams frame, vec2 ndc) {
    return vec3(frame.ray_forward) + ndc.x * vec3(frame.ray_right) + ndc.y * vec3(frame.ray_up);
}

/// Share of a surface's light that the air leaves on the way to the camera; the rest is the sky's. distance: m.
SHARED_FN float air_transmittance(FrameParams frame, float distance) { return exp(-frame.sky.w * distance); }

SHARED_END
