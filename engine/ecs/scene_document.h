// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/ecs/scene_upgrade.h"

namespace sl {

inline constexpr std::uint64_t most_scene_bytes = std::uint64_t{64} << 20;
inline constexpr std::size_t deepest_include = 8;
/// Of a file and all that it includes, each time that one is spoken of: what is read of them must not take long.
inline constexpr std::size_t most_scene_entities = std::size_t{1} << 17;

namespace scene_key {
inline constexpr std::string_view schema = "$schema";
inline constexpr std::string_view version = "secondlight_scene";
inline constexpr std::string_view description = "description";
inline constexpr std::string_view include = "include";
inline constexpr std::string_view entities = "entities";
inline constexpr std::string_view name = "name";
inline constexpr std::string_view parent = "parent";
inline constexpr std::string_view remove = "remove";
}  // namespace scene_key

/// What one file says about an entity.
struct SceneLayer {
    const nlohmann::json* object;
    std::string where;  ///< file and JSON pointer, for messages
    std::shared_ptr<const std::filesystem::path> folder;  ///< of the file; one for all that it says
};

/// An entity with all that the included files and the including one say about it, innermost first.
struct SceneEntity {
    std::string name;
    std::optional<std::string> parent;
    std::string where;  ///< of the layer that named the parent
    std::vector<SceneLayer> layers;
};

/// A scene file with its includes merged by entity name, all of the newest version. Names are unique; parents exist and
/// form no cycle; what the components hold is not looked at yet.
struct SceneDocument {
    std::string description, schema;  ///< empty where the file has none
    std::vector<SceneEntity> entities;
    std::vector<std::filesystem::path> paths;  ///< of the file and of what it includes, outermost first
    std::vector<std::shared_ptr<const nlohmann::json>> files;  ///< what the layers point into
};

/// Throws Error with file and place for whatever is wrong.
SceneDocument read_scene_document(const std::filesystem::path& path, std::span<const SceneUpgrade> upgrades = scene_upgrades);

}  // namespace sl
