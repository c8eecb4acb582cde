// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/input.h"

namespace sl {

/// Dear ImGui asks which keys are down when a frame begins, and would miss a key that went down and up again since the last
/// frame: such a key counts as down for one frame. After the backends' new frame, before ImGui::NewFrame.
void keep_taps(const Input& input);

}  // namespace sl
