// SPDX-License-Identifier: MIT
#pragma once

#include "editor/outcome.h"
#include "editor/scene_edit.h"

namespace sl {

/// What the bar remembers between frames.
struct SceneFileBar {
    std::string path;  ///< where Save writes; empty: the usual one
    std::string lost;  ///< what replacing the file there would lose, for the question whether to
    Outcome outcome;
};

/// Path, Save and Reload. A file that is there is only replaced once a person has said so. Inside a window.
void scene_file_bar(const EditedScene& scene, SceneFileBar& state);

/// Writes the scene, and makes its file the scene's own. Never throws: says what went wrong.
Outcome save_scene(const EditedScene& scene, const std::string& path);
/// Puts what the scene's file holds in place of all named entities; one step in the history. Where the file
/// cannot be read, nothing changes. Never throws.
Outcome reload_scene(const EditedScene& scene);

}  // namespace sl
