// SPDX-License-Identifier: MIT
#pragma once

#include "game/hall/hall.h"

namespace sl {

/// A hall as a binary glTF 2.0 file with its pictures in it, each mesh once however many nodes show it.
std::string hall_glb(const Hall& hall);

}  // namespace sl
