// SPDX-License-Identifier: MIT
#include "engine/ecs/world.h"

#include <bit>

namespace sl {

void World::destroy(Entity entity) {
    if (!alive(entity)) return;
    Record& record = records_[entity.index];
    for (std::uint64_t bits = record.components; bits != 0; bits &= bits - 1) {
        const auto number = static_cast<std::uint32_t>(std::countr_zero(bits));
        const std::size_t end = number == shared_bit ? pools_.size() : number + 1;
        for (std::size_t pool = number; pool < end; ++pool) {
            if (pools_[pool] != nullptr) pools_[pool]->erase(entity);
        }
    }
    ++record.generation;
    free(entity.index);
    --count_;
}

void World::free(std::uint32_t index) {
    Record& record = records_[index];
    record.components = 0;
    if (record.generation == 0)
        return;  // generations are used up: reuse would bring stale names back to life
    record.next_free = first_free_;
    first_free_ = index;
}

void World::clear() {
    for (const std::unique_ptr<PoolIndex>& pool : pools_) {
        if (pool != nullptr) pool->clear();
    }
    first_free_ = Entity::no_index;
    // From the back, so that indices are given out from the front again.
    for (auto index = static_cast<std::uint32_t>(records_.size()); index-- > 0;) {
        records_[index].generation += records_[index].generation % 2;
        free(index);
    }
    count_ = 0;
}

}  // namespace sl
