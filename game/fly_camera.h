// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/clock.h"
#include "engine/core/input.h"
#include "engine/ecs/app.h"
#include "engine/ecs/components/camera.h"
#include "engine/ecs/components/transform.h"
#include "engine/ecs/query.h"
#include "game/notice.h"

namespace sl {

/// How the camera flies; a resource.
struct FlyCamera {
    bool active = true;                ///< false: something else moves the camera
    double speed = 5.0;                ///< m/s
    double fast = 4.0;                 ///< factor while Shift is held
    float radians_per_unit = 0.0022f;  ///< of mouse movement
};

/// The rotation turned by a mouse movement: about the vertical, and up and down short of straight. Roll goes
/// away.
quat look_turned(const quat& rotation, vec2 radians);

/// Moves the first active camera, in its parent's space: WASD level, Q and E down and up, the captured mouse
/// turns, Ctrl and the wheel set the speed.
void fly_camera(Query<const Camera, Transform> cameras, const Input& input, const FrameClock& clock,
                FlyCamera& fly, Notice& notice);

/// The camera as a plugin; needs a FrameClock when it runs.
void add_fly_camera(App& app);

}  // namespace sl
