// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/math.h"

namespace sl {

/// Turns about +y, then the turned +x, then the turned +z, radians: how people think of a view's direction.
struct YawPitchRoll {
    float yaw = 0.0f;
    float pitch = 0.0f;
    float roll = 0.0f;
};

YawPitchRoll yaw_pitch_roll(const quat& rotation);
/// The rotation with its angles raised by `step`. Unlike making it anew from angles, this turns steadily also
/// where yaw and roll cannot be told apart.
quat turned(const quat& rotation, const YawPitchRoll& step);

/// Three numbers in degrees side by side; returns whether a person changed them.
bool edit_rotation(quat& rotation);

}  // namespace sl
