// SPDX-License-Identifier: MIT
#pragma once

#include "editor/frame_report.h"
#include "editor/outcome.h"
#include "editor/scene_edit.h"

namespace sl {

enum class PictureFormat { png, exr };

/// What the tab remembers between frames.
struct PictureTab {
    std::optional<PictureFormat> wish;  ///< a picture that the next frame should leave; whoever saves it resets this
    Outcome saved;                      ///< of the last picture
    Outcome copied;
    std::string command;  ///< that was copied last
};

/// Saves pictures and copies settings. Inside a window.
void picture_tab(const EditedScene& scene, const FrameReport& report, PictureTab& state);

}  // namespace sl
