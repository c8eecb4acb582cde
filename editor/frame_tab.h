// SPDX-License-Identifier: MIT
#pragma once

#include "editor/frame_report.h"
#include "editor/smoothed_times.h"
#include "engine/ecs/schedule.h"

namespace sl {

/// What the tab remembers between frames.
struct FrameTab {
    SmoothedTimes kinds, passes, systems;
};

/// GPU time per kind of pass, the frame graph as it was compiled, systems with their times, and what the scene
/// adds up to. Inside a window.
void frame_tab(const FrameReport& report, const Schedule& schedule, FrameTab& state);

}  // namespace sl
