// SPDX-License-Identifier: MIT
#pragma once

#include "editor/scene_edit.h"

namespace sl {

/// Buttons that say what they would undo and redo, and Ctrl+Z, Ctrl+Y and Ctrl+Shift+Z for them. Ends the
/// gesture that no widget goes on with. Inside a window.
void history_bar(const EditedScene& scene);

}  // namespace sl
