// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "engine/ecs/pool_index.h"

namespace sl {

/// Positions [first, last) of the smallest pool. Aligned: every pool holds the same entities there in the
/// same order, so that their packed arrays can be walked side by side without look-ups.
struct Stretch {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
    bool aligned = false;
};

/// How a tuple of pools is walked: the smallest pool leads, cut into stretches that cover it in order.
struct Alignment {
    std::size_t leader = 0;  ///< index of the smallest pool in the tuple
    std::vector<Stretch> stretches;
};

/// Remembers for tuples of pools which blocks are aligned. Only blocks whose pools changed since are compared
/// again.
class AlignmentCache {
  public:
    /// `key` names the tuple: the same key always comes with the same pools. The result holds until a pool
    /// changes.
    const Alignment& find(std::uint32_t key, std::span<const PoolIndex* const> pools);

  private:
    struct Entry {
        Alignment alignment;
        // Versions only grow, so their sum over the pools is the same exactly if each one is.
        std::uint64_t version = ~std::uint64_t{0};
        std::vector<std::uint64_t> block_versions;
        std::vector<bool> block_aligned;
    };

    static void refresh(Entry& entry, std::span<const PoolIndex* const> pools);

    // Queries of systems that run side by side ask at the same time; none of them changes a pool.
    std::mutex mutex_;
    std::vector<std::unique_ptr<Entry>> entries_;
};

}  // namespace sl
