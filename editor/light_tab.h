// SPDX-License-Identifier: MIT
#pragma once

#include "editor/frame_report.h"
#include "editor/pass_history.h"
#include "editor/scene_edit.h"

namespace sl {

/// What the tab remembers between frames.
struct LightTab {
    PassHistory history;  ///< of the passes that GI asked for
};

/// GI of the active camera and what it costs, all lights, camera and exposure. Inside a window.
void light_tab(const EditedScene& scene, const FrameReport& report, LightTab& state);

}  // namespace sl
