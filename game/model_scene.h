// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "engine/ecs/app.h"

namespace sl {

/// Whether a path is that of a model rather than of a scene file, by its ending.
bool is_model(const std::filesystem::path& path);

/// Makes an empty world a scene that shows a model: with a camera that sees all of it where the file has none, and a sun and a sky
/// where it has no light, which the log tells. Throws Error.
void show_model(App& app, const std::filesystem::path& path);

}  // namespace sl
