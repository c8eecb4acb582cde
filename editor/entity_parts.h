// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "editor/entity_keys.h"
#include "engine/ecs/component_registry.h"
#include "engine/ecs/scene_document.h"

namespace sl {

/// A part of an entity is known by a word: a component by its registered name, and besides these.
namespace entity_part {
inline constexpr std::string_view existence = "";
inline constexpr std::string_view name = scene_key::name;
inline constexpr std::string_view parent = scene_key::parent;
}  // namespace entity_part

/// What a part holds, as text: a component's JSON, the name itself, the parent's key. Nothing where the entity
/// lacks the part.
using PartValue = std::optional<std::string>;

/// Reads and writes entities part by part, knowing their components only by name.
struct EntityParts {
    World& world;
    const ComponentRegistry& registry;
    EntityKeys& keys;

    PartValue read(Entity entity, std::string_view part) const;
    /// All but the existence, which must be. What the part's field lists do not hold stays as it is.
    void write(Entity entity, std::string_view part, const PartValue& value) const;
    /// The words of all parts that the entity has, its existence left out.
    std::vector<std::string_view> of(Entity entity) const;
};

/// The JSON of a component as it comes.
std::string default_value(const ComponentType& type);

}  // namespace sl
