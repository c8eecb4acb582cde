// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/ecs/world.h"

namespace sl {

/// The named entities of a world by their parents, as they are when it is made. Entities without a name belong
/// to the systems that made them (a terrain's chunks) and are in neither the tree nor a scene file.
class EntityTree {
  public:
    explicit EntityTree(const World& world);

    /// Those without a named parent, by name.
    const std::vector<Entity>& roots() const { return below({}); }
    /// The children, by name.
    const std::vector<Entity>& below(Entity parent) const;
    /// All of them, by name.
    std::vector<Entity> all() const;

  private:
    void sort(std::vector<Entity>& entities) const;

    const World& world_;
    std::map<Entity, std::vector<Entity>> children_;
};

/// The entity and all that hang on it, each after its parent.
std::vector<Entity> with_all_below(const World& world, Entity entity);
/// Whether the entity is `above` or hangs on it.
bool is_below(const World& world, Entity entity, Entity above);

/// The entity's name, or "(no name)".
const std::string& shown_name(const World& world, Entity entity);
bool name_is_taken(const World& world, std::string_view name);
/// The wanted name where no entity has it, else that with the first free number after it. A number that it ends
/// in is replaced: beside "lamp 2" comes "lamp 3".
std::string free_name(const World& world, std::string_view wanted);

}  // namespace sl
