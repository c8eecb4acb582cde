// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "engine/core/math.h"
#include "engine/ecs/app.h"

namespace sl {

/// Makes an empty world a scene that shows a model: with a camera that sees all of it where the file has none, and a sun and a sky
/// where it has no light, which the log tells. Throws Error.
void show_model(App& app, const std::filesystem::path& path);

/// In world space, of all meshes that are there once the systems have run.
Bounds bounds_of_meshes(World& world);

}  // namespace sl
