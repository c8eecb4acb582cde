// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_table.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace sl {

namespace {

constexpr std::size_t words_of_a_name = 2, words_of_its_light = 4;

/// The power of two of which a word holds the brightest.
float unit_of(std::span<const vec3> irradiance) {
    float brightest = 0.0f;
    for (const vec3& value : irradiance) brightest = std::max({brightest, value.x, value.y, value.z});
    return brightest > 0.0f ? std::exp2(std::ceil(std::log2(brightest)) - 15.0f) : 1.0f;
}

}  // namespace

void FacetTable::place(std::span<const FacetEntry> entries) {
    slots = std::bit_ceil(static_cast<std::uint32_t>(std::max<std::size_t>(2 * entries.size(), 16)));
    words.assign(slots * (words_of_a_name + words_of_its_light), 0);
    longest_search = 1;
    slot_.resize(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const auto high = static_cast<std::uint32_t>(entries[i].name >> 32), low = static_cast<std::uint32_t>(entries[i].name);
        std::uint32_t at = facet_slot(high, low) & (slots - 1), search = 1;
        for (; words[at * words_of_a_name] != 0; at = (at + 1) & (slots - 1)) ++search;
        longest_search = std::max(longest_search, search);
        words[at * words_of_a_name] = entries[i].split ? high | facet_is_split : high;
        words[at * words_of_a_name + 1] = low;
        slot_[i] = at;
    }
}

void FacetTable::light(std::span<const FacetEntry> entries, std::span<const vec3> irradiance) {
    unit = unit_of(irradiance);
    // Once for each corner, and then a copy for each facet that has it.
    corners_.resize(irradiance.size());
    tbb::parallel_for(std::size_t{0}, irradiance.size(), [&](std::size_t i) { corners_[i] = facet_word(irradiance[i] / unit); });
    tbb::parallel_for(std::size_t{0}, entries.size(), [&](std::size_t i) {
        std::uint32_t* light = &words[slots * words_of_a_name + slot_[i] * words_of_its_light];
        for (std::size_t corner = 0; corner < 4; ++corner) light[corner] = corners_[entries[i].corners[corner]];
    });
}

}  // namespace sl
