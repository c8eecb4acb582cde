// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "shared/facets.h"

namespace sl {

/// A cell of the lattice, as one number.
using FacetName = std::uint64_t;

/// The name of a cell, in one number.
inline FacetName facet_name(const FacetCell& cell) { return (FacetName{cell.name.x} << 32) | cell.name.y; }

/// Exponent of a cell's side.
inline int facet_level_of(FacetName name) { return facet_name_level(static_cast<std::uint32_t>(name >> 32)); }

/// The name of the same cell when all positions change by `offset`, m: a whole number of its sides.
inline FacetName facet_name_moved(FacetName name, vec3 offset) {
    const auto high = static_cast<std::uint32_t>(name >> 32), low = static_cast<std::uint32_t>(name);
    const vec3 along = facet_axes(offset, facet_name_side(high) >> 1);
    const auto moved = [&](std::uint32_t number, float way, double cells) {
        return (number + static_cast<std::uint32_t>(std::llround(std::ldexp(way * cells, -facet_level_of(name))))) & 0xffffu;
    };
    // Off the surface there are eight to a side.
    const std::uint32_t x = moved(low & 0xffffu, along.x, 1), y = moved(low >> 16, along.y, 1), z = moved(high & 0xffffu, along.z, 8);
    return (FacetName{(high & ~0xffffu) | z} << 32) | (y << 16) | x;
}

/// Gives each entry the name of its cell when all positions change by `offset`, m.
template <class Value>
void move_names(std::unordered_map<FacetName, Value>& entries, vec3 offset) {
    std::unordered_map<FacetName, Value> moved;
    moved.reserve(entries.size());
    while (!entries.empty()) {
        auto entry = entries.extract(entries.begin());
        entry.key() = facet_name_moved(entry.key(), offset);
        moved.insert(std::move(entry));
    }
    entries = std::move(moved);
}

}  // namespace sl
