// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_table.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/gtc/packing.hpp>

namespace sl {

namespace {

constexpr std::size_t words_of_a_slot = 8;

/// A corner's irradiance as half floats behind one another.
std::array<std::uint16_t, 12> halves_of(const FacetEntry& entry, float unit) {
    std::array<std::uint16_t, 12> halves{};
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const vec3 value = entry.irradiance[corner] / unit;
        for (std::size_t c = 0; c < 3; ++c) halves[corner * 3 + c] = glm::packHalf1x16(value[static_cast<int>(c)]);
    }
    // Irradiance has no sign: the first one's bit is free.
    if (entry.split) halves[0] |= 0x8000u;
    return halves;
}

}  // namespace

void FacetTable::fill(const std::vector<FacetEntry>& entries) {
    float brightest = 0.0f;
    for (const FacetEntry& entry : entries) {
        for (const vec3& value : entry.irradiance) brightest = std::max({brightest, value.x, value.y, value.z});
    }
    unit = brightest > 0.0f ? std::exp2(std::ceil(std::log2(brightest)) - 15.0f) : 1.0f;
    slots = std::bit_ceil(static_cast<std::uint32_t>(std::max<std::size_t>(2 * entries.size(), 16)));
    words.assign(slots * words_of_a_slot, 0);
    longest_search = 1;
    for (const FacetEntry& entry : entries) {
        const auto high = static_cast<std::uint32_t>(entry.name >> 32), low = static_cast<std::uint32_t>(entry.name);
        std::uint32_t at = facet_slot(high, low) & (slots - 1), search = 1;
        for (; words[at * words_of_a_slot] != 0; at = (at + 1) & (slots - 1)) ++search;
        longest_search = std::max(longest_search, search);
        std::uint32_t* slot = &words[at * words_of_a_slot];
        slot[0] = high;
        slot[1] = low;
        const auto halves = halves_of(entry, unit);
        for (std::size_t i = 0; i < 6; ++i) slot[2 + i] = halves[2 * i] | (std::uint32_t{halves[2 * i + 1]} << 16);
    }
}

}  // namespace sl
