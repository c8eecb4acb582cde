// SPDX-License-Identifier: MIT
#pragma once

#include <type_traits>
#include <utility>

#include "engine/ecs/pool_index.h"
#include "engine/ecs/type_name.h"

namespace sl {

/// All components of one type: values and entities packed side by side, and a paged index from entity to
/// position. Pointers and references to values hold until a component of this type is added or removed.
template <class T>
class ComponentPool final : public PoolIndex {
    static_assert(std::is_object_v<T> && !std::is_const_v<T> && !std::is_same_v<T, bool>,
                  "a component is a plain movable type; wrap a bool in a struct that names it");

  public:
    /// Adds the component, or replaces the one that is there.
    T& add(Entity entity, T value) {
        if (T* old = find(entity)) return *old = std::move(value);
        return append(entity, std::move(value));
    }

    /// As add, for an entity that is known not to be in the pool.
    T& append(Entity entity, T value) {
        append_entity(entity);
        return values_.emplace_back(std::move(value));
    }

    bool erase(Entity entity) override {
        const std::uint32_t hole = position(entity);
        if (hole == none) return false;
        check_not_walked();
        if (hole + 1 != size()) values_[hole] = std::move(values_.back());
        values_.pop_back();
        remove_entity(hole);
        return true;
    }

    void clear() override {
        check_not_walked();
        values_.clear();
        clear_entities();
    }

    void swap_positions(std::uint32_t a, std::uint32_t b) override {
        check_not_walked();
        if (a == b) return;
        using std::swap;
        swap(values_[a], values_[b]);
        swap_entities(a, b);
    }

    /// Null where the entity has none.
    T* find(Entity entity) {
        const std::uint32_t at = position(entity);
        return at == none ? nullptr : &values_[at];
    }
    const T* find(Entity entity) const { return const_cast<ComponentPool*>(this)->find(entity); }

    /// The entity must have it.
    T& get(Entity entity) {
        T* value = find(entity);
        CHECK(value != nullptr, "entity {} (generation {}) has no {}", entity.index, entity.generation,
              type_name<T>());
        return *value;
    }
    const T& get(Entity entity) const { return const_cast<ComponentPool*>(this)->get(entity); }

    /// By position, parallel to entities().
    std::span<T> values() { return values_; }
    std::span<const T> values() const { return values_; }

  private:
    LargeVector<T> values_;
};

}  // namespace sl
