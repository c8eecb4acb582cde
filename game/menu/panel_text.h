// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "game/settings/key_bindings.h"

namespace sl {

/// How the editor panel works, a line for each of its tabs.
std::string panel_text(const KeyBindings& keys);

}  // namespace sl
