// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>

#include "engine/ecs/alignment.h"
#include "engine/ecs/component_pool.h"
#include "engine/ecs/resources.h"
#include "engine/ecs/type_number.h"

namespace sl {

/// Entities, one component pool per type, and resources. A stale name is never mistaken for the entity that
/// took its place: find and has answer no, get, add and remove stop, destroy does nothing. References to
/// components hold until a component of the same type is added or removed. While a query walks, record such
/// changes in Commands.
class World {
  public:
    /// A new entity; components of distinct types may come with it.
    template <class... T>
    Entity create(T... components);
    /// With all its components; nothing happens where it is dead.
    void destroy(Entity entity);
    /// Whether the name is of an entity that has not been destroyed since.
    bool alive(Entity entity) const {
        return entity.index < records_.size() && records_[entity.index].generation == entity.generation &&
               entity.generation % 2 == 1;
    }
    std::size_t entity_count() const { return count_; }
    /// Calls visit(entity) for each living entity, by index. `visit` may create and destroy.
    template <class F>
    void each_entity(F visit) const;
    /// Destroys all entities; names from before stay stale. Resources stay.
    void clear();

    /// Adds a component, or replaces the one that is there.
    template <class T>
    T& add(Entity entity, T value = {}) {
        check_alive(entity);
        records_[entity.index].components |= component_bit<T>();
        return pool<T>().add(entity, std::move(value));
    }
    /// Nothing happens where the living entity has none.
    template <class T>
    void remove(Entity entity) {
        check_alive(entity);
        if (ComponentPool<T>* found = find_pool<T>(); found != nullptr && found->erase(entity)) {
            if (component_number<T>() < shared_bit) records_[entity.index].components &= ~component_bit<T>();
        }
    }

    /// Null where the entity has none, or is dead.
    template <class T>
    T* find(Entity entity) {
        ComponentPool<T>* found = find_pool<T>();
        return found == nullptr ? nullptr : found->find(entity);
    }
    template <class T>
    const T* find(Entity entity) const {
        return const_cast<World*>(this)->find<T>(entity);
    }
    /// The entity must have it; stops with both names where it has not.
    template <class T>
    T& get(Entity entity) {
        T* value = find<T>(entity);
        CHECK(value != nullptr, "entity {} (generation {}) {} {}", entity.index, entity.generation,
              alive(entity) ? "has no" : "is dead and has no", type_name<T>());
        return *value;
    }
    template <class T>
    const T& get(Entity entity) const {
        return const_cast<World*>(this)->get<T>(entity);
    }
    template <class T>
    bool has(Entity entity) const {
        return find<T>(entity) != nullptr;
    }

    /// Moves the entities that have all these components to the front of each pool, in one order, so that
    /// queries over them walk plain arrays. Queries are right without it; call it when it pays: after
    /// loading, or now and then.
    template <class First, class... Others>
    void align();

    /// Things that the world has once, by type; see Resources.
    Resources& resources() { return resources_; }
    const Resources& resources() const { return resources_; }
    /// It must be there.
    template <class R>
    R& resource() {
        return resources_.get<R>();
    }
    template <class R>
    const R& resource() const {
        return resources_.get<R>();
    }
    /// Null where there is none.
    template <class R>
    R* find_resource() {
        return resources_.find<R>();
    }
    template <class R>
    const R* find_resource() const {
        return resources_.find<R>();
    }
    /// Replaces the one that is there.
    template <class R>
    R& add_resource(R value) {
        return resources_.add<R>(std::move(value));
    }
    /// The same, made in place: for types that cannot be moved.
    template <class R, class... Args>
    R& emplace_resource(Args&&... args) {
        return resources_.emplace<R>(std::forward<Args>(args)...);
    }

    /// The pool of T, made on first use. Only for code that walks pools itself, as Query does.
    template <class T>
    ComponentPool<T>& pool();
    /// Null where no entity has ever had one.
    template <class T>
    ComponentPool<T>* find_pool() {
        const std::size_t number = component_number<T>();
        return number < pools_.size() ? static_cast<ComponentPool<T>*>(pools_[number].get()) : nullptr;
    }
    template <class T>
    const ComponentPool<T>* find_pool() const {
        return const_cast<World*>(this)->find_pool<T>();
    }
    AlignmentCache& alignments() const { return *alignments_; }

  private:
    /// Odd generations live, even ones are free.
    struct Record {
        std::uint32_t generation = 0;
        std::uint32_t next_free = Entity::no_index;
        std::uint64_t components =
            0;  ///< bit per component number; the last bit stands for all numbers from there on
    };
    static constexpr std::uint32_t shared_bit = 63;

    template <class T>
    static std::uint32_t component_number() {
        return type_number<PoolIndex, T>();
    }
    template <class T>
    static std::uint64_t component_bit() {
        return std::uint64_t{1} << std::min(component_number<T>(), shared_bit);
    }

    Entity allocate(std::uint64_t components);
    void free(std::uint32_t index);
    void check_alive(Entity entity) const {
        CHECK(alive(entity), "entity {} (generation {}) is dead", entity.index, entity.generation);
    }

    LargeVector<Record> records_;
    std::uint32_t first_free_ = Entity::no_index;
    std::size_t count_ = 0;
    std::vector<std::unique_ptr<PoolIndex>> pools_;
    Resources resources_;
    std::unique_ptr<AlignmentCache> alignments_ = std::make_unique<AlignmentCache>();
};

inline Entity World::allocate(std::uint64_t components) {
    std::uint32_t index = first_free_;
    if (index == Entity::no_index) {
        index = static_cast<std::uint32_t>(records_.size());
        CHECK(index != Entity::no_index, "more than {} entities", index);
        records_.emplace_back();
    } else {
        first_free_ = records_[index].next_free;
    }
    Record& record = records_[index];
    ++record.generation;
    record.components = components;
    ++count_;
    return {index, record.generation};
}

template <class... T>
Entity World::create(T... components) {
    const Entity entity = allocate((std::uint64_t{0} | ... | component_bit<T>()));
    (pool<T>().append(entity, std::move(components)), ...);
    return entity;
}

template <class F>
void World::each_entity(F visit) const {
    const std::size_t end = records_.size();  // what `visit` creates is not visited
    for (std::uint32_t index = 0; index < end; ++index) {
        if (records_[index].generation % 2 == 1) visit(Entity{index, records_[index].generation});
    }
}

template <class T>
ComponentPool<T>& World::pool() {
    const std::size_t number = component_number<T>();
    if (number >= pools_.size()) pools_.resize(number + 1);
    if (pools_[number] == nullptr) pools_[number] = std::make_unique<ComponentPool<T>>();
    return static_cast<ComponentPool<T>&>(*pools_[number]);
}

template <class First, class... Others>
void World::align() {
    PoolIndex& leader = pool<First>();
    const std::array<PoolIndex*, sizeof...(Others)> others{&pool<Others>()...};
    std::uint32_t shared = 0;
    // What is swapped away from `shared` was found before not to be shared, so one walk over the leader is
    // enough.
    for (std::uint32_t at = 0; at < leader.size(); ++at) {
        const Entity entity = leader.entities()[at];
        const auto holds_it = [&](const PoolIndex* pool) { return pool->contains(entity); };
        if (!std::all_of(others.begin(), others.end(), holds_it)) continue;
        if (at != shared) leader.swap_positions(at, shared);
        for (PoolIndex* pool : others) {
            const std::uint32_t position = pool->position(entity);
            if (position != shared) pool->swap_positions(position, shared);
        }
        ++shared;
    }
}

}  // namespace sl
