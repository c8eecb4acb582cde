// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "engine/ecs/component_registry.h"

namespace sl {

/// Which scene the world holds, a resource.
struct SceneInfo {
    std::string description;
    std::filesystem::path path;
};

/// Adds the entities of a scene file to the world and sets SceneInfo. Throws Error naming file and place for
/// whatever is wrong; the world is then as before.
///     {"secondlight_scene": 1, "description": "…", "include": "village.json",
///      "entities": [{"name": "sun", "parent": "sky", "transform": {…}, "sun": {…}}, …]}
/// Entities of the included file (relative, in the same folder or below) are merged with those of the same
/// name: single fields override, a component set to null is dropped, "remove": true drops the entity.
void read_scene(World& world, const ComponentRegistry& registry, const std::filesystem::path& path);

/// Writes every entity with a Name and its registered components, without includes. Replaces the file whole
/// or not at all. Throws Error where the file cannot be written, or could not be read back: two entities of
/// one name, a parent without one.
void write_scene(const World& world, const ComponentRegistry& registry, const std::filesystem::path& path);

}  // namespace sl
