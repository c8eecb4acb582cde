// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>

#include "engine/render/gi/facet_light.h"
#include "engine/render/gi/gi.h"

namespace sl {

namespace {

/// Of the budget, what is gathered in even where the passes on the GPU alone take all of it: light must not stand still.
constexpr double least_share = 0.25;

double gathering_seconds(const FrameInput& frame, const Facets& settings) {
    const double budget = 1e-3 * settings.budget_ms;
    return std::max(budget - frame.gi_gpu_seconds, least_share * budget);
}

}  // namespace

GiResult indirect_light(const FrameInput& frame, const GBuffer& gbuffer, const Facets& settings) {
    FacetLight& light = frame.facets;
    float progress = 0.0f;
    const auto start = std::chrono::steady_clock::now();
    // A capture's frames before its last one are not looked at.
    if (frame.slice_budget > 0) {
        const bool at_once = frame.slice_budget == ~0u;
        progress = light.cache.update(frame.scene, frame.params, settings, {.seconds = at_once ? 0.0 : gathering_seconds(frame, settings)});
    }
    const FacetTable& table = light.cache.table();
    if (table.slots == 0) return {.irradiance = frame.graph.black(), .progress = progress};
    if (light.uploaded != light.cache.version()) {
        light.table.upload(table.words, "facets");
        light.uploaded = light.cache.version();
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    FacetParams params{};
    params.grid = vec4(facet_side_over_distance(frame.params, settings), table.unit, settings.strength, 0.0f);
    params.table = uvec4(table.slots - 1, table.longest_search, 0, 0);
    auto pass = frame.graph.fullscreen("facets", "gi/facets.frag");
    pass.params("Frame", frame.params)
        .params("Facets", params)
        .storage("Table", frame.graph.import_buffer("facets", table.words.size() * sizeof(std::uint32_t), light.table.id()))
        .read("depth", gbuffer.depth)
        .read("normal", gbuffer.vertex_normal);
    return {.irradiance = pass.create("irradiance", frame.screen(Format::rgba32f)), .progress = progress, .traced_seconds = seconds, .error = light.cache.error()};
}

}  // namespace sl
