// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "engine/ecs/component_registry.h"

namespace sl {

struct SceneDocument;

/// Which scene the world holds, a resource.
struct SceneInfo {
    std::string description;
    std::filesystem::path path;
    std::string schema{};  ///< the file's "$schema": URL or file name
    /// Where the names of files begin that the world holds, if that is not beside `path`: a scene that has been saved in
    /// another folder goes on with the names that it has.
    std::filesystem::path folder{};
};

/// Where the names of files begin that components of the world hold; empty for the current folder.
std::filesystem::path references_folder(const World& world);

/// Adds the entities of a scene file to the world and sets SceneInfo. Throws Error naming file and place for
/// whatever is wrong; the world is then as before.
///     {"secondlight_scene": 1, "description": "…", "include": "village.json",
///      "entities": [{"name": "sun", "parent": "sky", "transform": {…}, "sun": {…}}, …]}
/// Entities of the included file (relative, in the same folder or below) are merged with those of the same
/// name: single fields override, a component set to null is dropped, "remove": true drops the entity. Each file names
/// others relative to itself. Comments (// and /* */) are passed over; docs/scene.schema.json has all the rest.
void read_scene(World& world, const ComponentRegistry& registry, const std::filesystem::path& path);

/// The same of a file that has been read (scene_document.h).
void add_scene(World& world, const ComponentRegistry& registry, const SceneDocument& document);

/// Writes every entity with a Name and its registered components, without includes and comments. Names of files become
/// relative to the one that is written. Replaces the file whole or not at all. Throws Error where the file cannot be
/// written, or could not be read back: two entities of one name, a parent without one.
void write_scene(const World& world, const ComponentRegistry& registry, const std::filesystem::path& path);

}  // namespace sl
