// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/core/gamepad.h"

namespace sl {

/// The first gamepad that GLFW knows; nothing where there is none.
std::optional<GamepadReading> read_gamepad();

}  // namespace sl
