// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/input.h"

namespace sl {

/// Lets keyboard and gamepad move among the widgets of the frame that is about to begin, or keeps them from it: arrows, cross and
/// left stick move, Space, Enter and A press, B cancels. After the backends' new frame, before ImGui::NewFrame.
void navigate_widgets(bool on, const Input& input);

}  // namespace sl
