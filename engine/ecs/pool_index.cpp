// SPDX-License-Identifier: MIT
#include "engine/ecs/pool_index.h"

#include <utility>

namespace sl {

void PoolIndex::add_page(std::size_t page) {
    if (page >= pages_.size()) pages_.resize(page + 1);
    pages_[page] = std::make_unique<Slot[]>(page_size);
}

void PoolIndex::swap_entities(std::uint32_t a, std::uint32_t b) {
    std::swap(entities_[a], entities_[b]);
    slot(entities_[a]).position = a;
    slot(entities_[b]).position = b;
    touch(a);
    touch(b);
}

void PoolIndex::clear_entities() {
    for (const Entity entity : entities_) slot(entity) = {};
    entities_.clear();
    ++version_;
    for (std::uint64_t& version : block_versions_) ++version;
}

}  // namespace sl
