// SPDX-License-Identifier: MIT
#pragma once

#include "editor/scene_edit.h"

namespace sl {

/// Name, parent and components of a living entity. Inside a window.
void inspector(const EditedScene& scene, Entity entity);

}  // namespace sl
