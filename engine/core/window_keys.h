// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/core/input.h"

namespace sl {

/// The key that GLFW calls `glfw_key`; none for those that the game has no use for.
std::optional<Key> key_of(int glfw_key);

}  // namespace sl
