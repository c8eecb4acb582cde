// SPDX-License-Identifier: MIT
#include "engine/ecs/alignment.h"

#include <algorithm>

namespace sl {

namespace {

constexpr std::uint64_t never_seen = ~std::uint64_t{0};

bool same_entities(std::span<const PoolIndex* const> pools, std::uint32_t first, std::uint32_t last) {
    const Entity* expected = pools[0]->entities().data();
    return std::all_of(pools.begin() + 1, pools.end(), [&](const PoolIndex* pool) {
        return std::equal(expected + first, expected + last, pool->entities().data() + first);
    });
}

void append_stretch(std::vector<Stretch>& stretches, Stretch stretch) {
    if (!stretches.empty() && stretches.back().aligned == stretch.aligned) {
        stretches.back().last = stretch.last;
    } else {
        stretches.push_back(stretch);
    }
}

}  // namespace

const Alignment& AlignmentCache::find(std::uint32_t key, std::span<const PoolIndex* const> pools) {
    std::uint64_t version = 0;
    for (const PoolIndex* pool : pools) version += pool->version();

    const std::lock_guard lock(mutex_);
    if (key >= entries_.size()) entries_.resize(key + 1);
    if (entries_[key] == nullptr) entries_[key] = std::make_unique<Entry>();
    Entry& entry = *entries_[key];
    if (entry.version != version) {
        refresh(entry, pools);
        entry.version = version;
    }
    return entry.alignment;
}

void AlignmentCache::refresh(Entry& entry, std::span<const PoolIndex* const> pools) {
    const auto smallest =
        std::min_element(pools.begin(), pools.end(),
                         [](const PoolIndex* a, const PoolIndex* b) { return a->size() < b->size(); });
    const std::uint32_t size = (*smallest)->size();
    const std::size_t blocks = (std::size_t{size} + PoolIndex::block_size - 1) / PoolIndex::block_size;
    if (blocks > entry.block_versions.size()) {
        entry.block_versions.resize(blocks, never_seen);
        entry.block_aligned.resize(blocks, false);
    }
    entry.alignment.leader = static_cast<std::size_t>(smallest - pools.begin());
    entry.alignment.stretches.clear();
    for (std::size_t block = 0; block < blocks; ++block) {
        const auto first = static_cast<std::uint32_t>(block * PoolIndex::block_size);
        const std::uint32_t last = std::min(first + PoolIndex::block_size, size);
        std::uint64_t version = 0;
        for (const PoolIndex* pool : pools) version += pool->block_version(block);
        if (entry.block_versions[block] != version) {
            entry.block_versions[block] = version;
            entry.block_aligned[block] = same_entities(pools, first, last);
        }
        append_stretch(entry.alignment.stretches, {first, last, entry.block_aligned[block]});
    }
}

}  // namespace sl
