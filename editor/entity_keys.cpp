// SPDX-License-Identifier: MIT
#include "editor/entity_keys.h"

#include "engine/core/check.h"

namespace sl {

EntityKey EntityKeys::key_of(Entity entity) {
    const auto [found, added] = keys_.try_emplace(entity, EntityKey{entities_.size() + 1});
    if (added) entities_.push_back(entity);
    return found->second;
}

Entity EntityKeys::entity_of(EntityKey key) const {
    if (key == EntityKey::none) return {};
    const auto index = static_cast<std::size_t>(key) - 1;
    return index < entities_.size() ? entities_[index] : Entity{};
}

void EntityKeys::give(EntityKey key, Entity entity) {
    const auto index = static_cast<std::size_t>(key) - 1;
    CHECK(index < entities_.size(), "key {} was never given out", index + 1);
    entities_[index] = entity;
    keys_[entity] = key;
}

}  // namespace sl
