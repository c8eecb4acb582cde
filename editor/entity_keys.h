// SPDX-License-Identifier: MIT
#pragma once

#include <unordered_map>
#include <vector>

#include "engine/ecs/entity.h"

namespace sl {

/// Names an entity also after its death: one that comes back when its deletion is undone has its old key.
enum class EntityKey : std::uint64_t { none };

/// Which entity has which key.
class EntityKeys {
  public:
    /// The entity's key, a new one where it has none yet.
    EntityKey key_of(Entity entity);
    /// The entity that had the key last; it may be dead. Null for EntityKey::none.
    Entity entity_of(EntityKey key) const;
    /// From now on the key means this entity.
    void give(EntityKey key, Entity entity);

  private:
    std::vector<Entity> entities_;  ///< key 1 is the first
    std::unordered_map<Entity, EntityKey> keys_;
};

}  // namespace sl
