// SPDX-License-Identifier: MIT
#pragma once

#include "editor/scene_edit.h"
#include "editor/scene_file_bar.h"

namespace sl {

/// What the tab remembers between frames.
struct SceneTab {
    std::string filter;                      ///< shows entities whose name contains it
    EntityKey selected = EntityKey::none;    ///< by key, so that it is still chosen when its deletion is undone
    SceneFileBar file;
};

/// The scene's file, the tree of named entities, and the components of the chosen one. Inside a window.
void scene_tab(const EditedScene& scene, SceneTab& state);

/// The chosen entity; null where it is gone or none is.
Entity selected_entity(const EditedScene& scene, const SceneTab& state);

}  // namespace sl
