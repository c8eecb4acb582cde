// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "engine/core/math.h"
#include "engine/ecs/app.h"

namespace sl {

/// Makes an empty world a scene that is to show a model.
void add_model_scene(App& app, const std::filesystem::path& path);

/// Once the model is there: gives the scene a camera that sees all of it where the file has none, and a sun and a sky where it has
/// no light, which the log tells.
void complete_model_scene(App& app);

/// In world space, of all meshes that are there once the systems have run.
Bounds bounds_of_meshes(World& world);
/// Of the same, each copy counted.
std::size_t triangles_of_meshes(World& world);

}  // namespace sl
