// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "engine/core/fields.h"

namespace sl {

/// A view along -z of its entity. The first camera in the world that is active is the one rendered.
struct Camera {
    float fov_y = 1.0472f;
    float height = 0.0f;
    float near = 0.02f;
    float ev100 = 12.0f;
    bool auto_exposure = false;
    bool antialias = true;
    bool active = true;
};

inline void visit_fields(FieldVisitor& visit, Camera& camera) {
    visit.field("fov_y", camera.fov_y,
                {.min = 0.01, .max = 2.9, .unit = "rad", .help = "Vertical angle of view; more shows more and makes things smaller.",
                 .look = FieldLook::angle});
    visit.field("height", camera.height,
                {.min = 0, .max = 1e6, .unit = "m",
                 .help = "What is seen from bottom to top, at one size however far away (orthographic); 0 sees in perspective."});
    visit.field("near", camera.near,
                {.min = 1e-6, .max = 1e3, .unit = "m",
                 .help = "Nothing nearer is drawn; less costs no precision, because depth is reversed.",
                 .look = FieldLook::logarithmic});
    visit.field("ev100", camera.ev100,
                {.min = -10, .max = 24, .unit = "EV",
                 .help = "Exposure value at ISO 100; one more halves the brightness. Sunny day 15, lit room 7."});
    visit.field("auto_exposure", camera.auto_exposure,
                {.help = "Follows the picture's brightness round ev100 as eyes do, in seconds; off keeps pictures comparable."});
    visit.field("antialias", camera.antialias, {.help = "Smooths edges of the tonemapped picture; costs one full-screen pass."});
    visit.field("active", camera.active, {.help = "The first active camera is the one rendered."});
}

/// A camera as one in perspective, which is the only kind that what draws and traces knows.
struct Lens {
    float fov_y;   ///< rad
    float near;    ///< m
    float behind;  ///< m: how far behind the camera's place it stands
};

/// One with a height stands so far behind that lines of sight are parallel but for 0.03 degrees: a thing is 1 % smaller ten heights
/// farther away.
inline Lens lens_of(const Camera& camera) {
    constexpr float heights_behind = 1000.0f;
    if (camera.height <= 0.0f) return {.fov_y = camera.fov_y, .near = camera.near, .behind = 0.0f};
    const float behind = heights_behind * camera.height;
    return {.fov_y = 2.0f * std::atan(0.5f / heights_behind), .near = camera.near + behind, .behind = behind};
}

}  // namespace sl
