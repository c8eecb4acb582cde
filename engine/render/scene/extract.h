// SPDX-License-Identifier: MIT
#pragma once

#include "engine/ecs/world.h"
#include "engine/render/scene/render_scene.h"

namespace sl {

/// Refills `scene` from the world: the one place that sees both. Reuses the arrays of the last frame.
void extract(World& world, RenderScene& scene);

}  // namespace sl
