// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <functional>

namespace sl {

/// Names an entity of a World. Null by default; once its entity is destroyed the name is stale for ever, even
/// when the index is used again, because the generation differs. A World gives out odd generations only.
struct Entity {
    static constexpr std::uint32_t no_index = ~0u;
    std::uint32_t index = no_index;
    std::uint32_t generation = 0;

    /// Whether this is a name at all; ask World::alive whether it still names something.
    explicit operator bool() const { return index != no_index; }
    auto operator<=>(const Entity&) const = default;
};

}  // namespace sl

/// Entities as keys of unordered containers.
template <>
struct std::hash<sl::Entity> {
    std::size_t operator()(const sl::Entity& entity) const noexcept {
        const std::uint64_t bits = (std::uint64_t{entity.generation} << 32) | entity.index;
        return static_cast<std::size_t>((bits ^ (bits >> 29)) * 0x9e3779b97f4a7c15ull);
    }
};
