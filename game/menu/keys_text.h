// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "game/settings/key_bindings.h"

namespace sl {

/// What the keys do now, a line each.
std::string keys_text(const KeyBindings& keys);

}  // namespace sl
