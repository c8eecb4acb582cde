// SPDX-License-Identifier: MIT
#include "engine/render/facets/facet_smoothing.h"

#include <algorithm>
#include <cmath>

#include "engine/core/math.h"

namespace sl {

namespace {

constexpr int rounds = 3;
/// Noise from which on a corner asks its neighbours, more than what any setting of gi.quality ends with: below it, what
/// smoothing blurs costs more than what it steadies gains. And so much more noise has it ask in earnest.
constexpr float listens_above = 0.2f, listens_fully = 0.2f;
/// By so much of itself light differs from corner to corner even where both are known.
constexpr float usual_step = 0.1f;

/// Both ends of each side of a facet.
template <class F>
void each_side(const FacetEntry& facet, F visit) {
    visit(facet.corners[0], facet.corners[1]);
    visit(facet.corners[2], facet.corners[3]);
    visit(facet.corners[0], facet.corners[2]);
    visit(facet.corners[1], facet.corners[3]);
}

}  // namespace

void FacetSmoothing::know_surroundings(std::span<const FacetEntry> facets, std::span<const vec3> irradiance, std::span<const float> variance) {
    around_.assign(irradiance.size(), vec2(0.0f));
    for (std::size_t i = 0; i < irradiance.size(); ++i) {
        if (variance[i] >= 0.0f) around_[i] = vec2(luminance(irradiance[i]), 1.0f);
    }
    for (const FacetEntry& facet : facets) {
        each_side(facet, [&](std::uint32_t a, std::uint32_t b) {
            if (variance[a] < 0.0f || variance[b] < 0.0f) return;
            around_[a] += vec2(luminance(irradiance[b]), 1.0f);
            around_[b] += vec2(luminance(irradiance[a]), 1.0f);
        });
    }
    // A corner that has missed the light seems dark and sure of it: it is as unsure as its surroundings are bright.
    unsure_.resize(irradiance.size());
    for (std::size_t i = 0; i < irradiance.size(); ++i) {
        const float mean = around_[i].y > 0.0f ? around_[i].x / around_[i].y : 0.0f;
        around_[i].x = mean;
        unsure_[i] = variance[i] * mean * mean;
    }
}

void FacetSmoothing::smooth(std::span<const FacetEntry> facets, std::span<vec3> irradiance, std::span<const float> variance) {
    know_surroundings(facets, irradiance, variance);
    for (int round = 0; round < rounds; ++round) {
        sums_.assign(irradiance.size(), vec4(0.0f));
        for (const FacetEntry& facet : facets) {
            each_side(facet, [&](std::uint32_t a, std::uint32_t b) {
                if (variance[a] < 0.0f || variance[b] < 0.0f) return;
                const float step = usual_step * 0.5f * (around_[a].x + around_[b].x), differs = step * step;
                if (!(differs > 0.0f)) return;
                // A side belongs to two facets, each of which tells of it: together once.
                const float from_a = 0.5f / (unsure_[a] + differs), from_b = 0.5f / (unsure_[b] + differs);
                sums_[a] += vec4(irradiance[b], 1.0f) * from_b;
                sums_[b] += vec4(irradiance[a], 1.0f) * from_a;
            });
        }
        for (std::size_t i = 0; i < irradiance.size(); ++i) {
            const float listens = variance[i] > 0.0f ? std::clamp((std::sqrt(variance[i]) - listens_above) / listens_fully, 0.0f, 1.0f) : 0.0f;
            if (!(listens > 0.0f) || !(unsure_[i] > 0.0f) || !(sums_[i].w > 0.0f)) continue;
            const float own = 1.0f / unsure_[i], all = own + listens * sums_[i].w;
            irradiance[i] = (irradiance[i] * own + listens * vec3(sums_[i])) / all;
            unsure_[i] = 1.0f / all;
        }
    }
}

}  // namespace sl
