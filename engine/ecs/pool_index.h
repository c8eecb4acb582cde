// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "engine/core/check.h"
#include "engine/ecs/entity.h"
#include "engine/ecs/large_vector.h"

namespace sl {

/// Which entities a component pool holds and at which position: the half of a sparse set that does not depend
/// on the component's type.
class PoolIndex {
  public:
    static constexpr std::uint32_t none = ~0u;
    /// Positions per block; alignment between pools is remembered by blocks.
    static constexpr std::uint32_t block_size = 1024;

    PoolIndex() = default;
    PoolIndex(const PoolIndex&) = delete;
    PoolIndex& operator=(const PoolIndex&) = delete;
    virtual ~PoolIndex() = default;

    std::uint32_t size() const { return static_cast<std::uint32_t>(entities_.size()); }
    /// By position, parallel to the values.
    std::span<const Entity> entities() const { return entities_; }
    bool contains(Entity entity) const { return position(entity) != none; }

    /// Where the entity's component lies, or `none`. A stale name finds nothing, without a look at the entity
    /// table.
    std::uint32_t position(Entity entity) const {
        const std::size_t page = entity.index / page_size;
        if (page >= pages_.size() || pages_[page] == nullptr) return none;
        const Slot slot = pages_[page][entity.index % page_size];
        return slot.generation == entity.generation ? slot.position : none;
    }

    /// Counts every change of who lies where, never falls. So does block_version for the positions of one
    /// block.
    std::uint64_t version() const { return version_; }
    std::uint64_t block_version(std::size_t block) const {
        return block < block_versions_.size() ? block_versions_[block] : 0;
    }

    /// The last component moves into the hole. False where there was nothing to remove.
    virtual bool erase(Entity entity) = 0;
    virtual void clear() = 0;
    virtual void swap_positions(std::uint32_t a, std::uint32_t b) = 0;

    /// While held, adding to and removing from the pool stops: somebody walks over its arrays.
    class Pin {
      public:
        explicit Pin(const PoolIndex* pool) : pool_(pool) {
            if (pool_ != nullptr) pool_->pins_.fetch_add(1, std::memory_order_relaxed);
        }
        ~Pin() {
            if (pool_ != nullptr) pool_->pins_.fetch_sub(1, std::memory_order_relaxed);
        }
        Pin(const Pin&) = delete;
        Pin& operator=(const Pin&) = delete;

      private:
        const PoolIndex* pool_;
    };

  protected:
    /// Gives the entity the next position; it must not be in the pool.
    void append_entity(Entity entity);
    /// Takes the entity at `hole` out and puts the last one there.
    void remove_entity(std::uint32_t hole);
    void swap_entities(std::uint32_t a, std::uint32_t b);
    void clear_entities();
    void check_not_walked() const {
        CHECK(pins_.load(std::memory_order_relaxed) == 0,
              "a component is added or removed while a query walks over its pool: use Commands");
    }

  private:
    static constexpr std::uint32_t page_size = 1024;
    struct Slot {
        std::uint32_t position = none;
        std::uint32_t generation = 0;
    };

    Slot& slot(Entity entity) { return pages_[entity.index / page_size][entity.index % page_size]; }
    void add_page(std::size_t page);
    void touch(std::uint32_t position) {
        ++version_;
        ++block_versions_[position / block_size];
    }

    LargeVector<Entity> entities_;
    std::vector<std::unique_ptr<Slot[]>> pages_;
    std::vector<std::uint64_t> block_versions_;
    std::uint64_t version_ = 0;
    mutable std::atomic<std::uint32_t> pins_{0};
};

inline void PoolIndex::append_entity(Entity entity) {
    check_not_walked();
    const std::size_t page = entity.index / page_size;
    if (page >= pages_.size() || pages_[page] == nullptr) [[unlikely]]
        add_page(page);
    Slot& place = slot(entity);
    CHECK(place.position == none, "entity {} is in the pool with generation {}, not {}", entity.index,
          place.generation, entity.generation);
    const std::uint32_t position = size();
    place = {position, entity.generation};
    entities_.push_back(entity);
    if (position / block_size >= block_versions_.size()) [[unlikely]]
        block_versions_.push_back(0);
    touch(position);
}

inline void PoolIndex::remove_entity(std::uint32_t hole) {
    const std::uint32_t last = size() - 1;
    const Entity moved = entities_[last];
    slot(entities_[hole]) = {};
    if (hole != last) {
        slot(moved).position = hole;
        entities_[hole] = moved;
        touch(hole);
    }
    entities_.pop_back();
    touch(last);
}

}  // namespace sl
