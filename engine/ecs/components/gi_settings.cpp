// SPDX-License-Identifier: MIT
#include "engine/ecs/components/gi_settings.h"

#include <algorithm>
#include <cmath>

namespace sl {

namespace {

constexpr FieldInfo rsm_size_info{.min = 4, .max = 1024, .unit = "texels",
                                  .help = "Side of each light's reflective shadow map; more texels resolve smaller lit patches and "
                                          "cost in proportion to their number."};
constexpr FieldInfo strength_info{.min = 0, .max = 10, .help = "Factor on indirect light; 1 is physical."};

struct FacetPreset {
    float spacing, noise;
};
/// At quality 0, 1/4 … 1: of all pairs that were measured those with the least error for their time (docs/gi.md).
constexpr std::array<FacetPreset, 5> facet_presets{{{16.0f, 0.2f}, {11.3f, 0.14f}, {Facets{}.spacing, Facets{}.noise}, {2.8f, 0.07f}, {2.0f, 0.05f}}};
constexpr auto facet_intervals = static_cast<float>(facet_presets.size() - 1);

/// In between, both change by equal factors.
FacetPreset facet_preset(float quality) {
    const float place = std::clamp(quality, 0.0f, 1.0f) * facet_intervals;
    const auto below = std::min(static_cast<std::size_t>(place), facet_presets.size() - 2);
    const float part = place - static_cast<float>(below);
    const auto between = [&](float a, float b) { return a * std::pow(b / a, part); };
    const FacetPreset &low = facet_presets[below], &high = facet_presets[below + 1];
    return {between(low.spacing, high.spacing), between(low.noise, high.noise)};
}

float facet_quality(const Facets& facets) {
    const auto finer = std::ranges::find_if(facet_presets, [&](const FacetPreset& preset) { return preset.spacing <= facets.spacing; });
    if (finer == facet_presets.begin()) return 0.0f;
    if (finer == facet_presets.end()) return 1.0f;
    const float part = std::log(facets.spacing / (finer - 1)->spacing) / std::log(finer->spacing / (finer - 1)->spacing);
    return (static_cast<float>(finer - facet_presets.begin() - 1) + part) / facet_intervals;
}

struct GridPreset {
    std::string_view name;
    float strength, angle_threshold;
};
// The paper's two parameter sets: its pictures, and its figure 3-3 that shows the dividing lines.
constexpr std::array<GridPreset, 2> grid_presets{{{"paper", 0.3f, 0.01f}, {"paper-artefact", 0.6f, 0.05f}}};
constexpr std::array<std::string_view, 3> grid_preset_names{"custom", grid_presets[0].name, grid_presets[1].name};

std::size_t preset_of(const RsmGrid& grid) {
    for (std::size_t i = 0; i < grid_presets.size(); ++i) {
        const RsmGrid preset{.strength = grid_presets[i].strength, .angle_threshold = grid_presets[i].angle_threshold};
        if (grid.strength == preset.strength && grid.angle_threshold == preset.angle_threshold &&
            grid.distance_attenuation == preset.distance_attenuation && grid.cutoff == preset.cutoff) {
            return i + 1;
        }
    }
    return 0;
}

}  // namespace

void visit_fields(FieldVisitor&, GiOff&) {}

void visit_fields(FieldVisitor& visit, Facets& facets) {
    // No state of its own: it is read off the facets' side, and choosing another one sets that and the noise.
    const float before = facet_quality(facets);
    float quality = before;
    visit.field("quality", quality, {.min = 0, .max = 1, .help = "Sets spacing and noise together, to what was measured to be nearest for its time: 0 is coarse and soon there, 1 fine and ten times later; a frame costs the same."});
    if (quality != before) {
        facets.spacing = facet_preset(quality).spacing;
        facets.noise = facet_preset(quality).noise;
    }
    visit.field("budget_ms", facets.budget_ms, {.min = 0.5, .max = 1000, .unit = "ms", .help = "What GI may take of a frame in a window, its passes on the GPU included; less leaves new and changed light coarse for longer."});
    visit.field("spacing", facets.spacing, {.min = 1, .max = 64, .unit = "pixels", .help = "Width of a facet on the screen; less resolves finer light and costs with its square."});
    visit.field("noise", facets.noise, {.min = 0.005, .max = 1, .help = "Standard error at a corner, over its irradiance, at which it gets no more rays; half of it costs up to four times as much."});
    visit.field("bounces", facets.bounces, {.min = 0, .max = 64, .help = "Reflections of light before it arrives; 64 is all that can be seen."});
    visit.field("strength", facets.strength, strength_info);
}

void visit_fields(FieldVisitor& visit, RsmExact& exact) {
    visit.field("rsm_size", exact.rsm_size, rsm_size_info);
    visit.field("strength", exact.strength, strength_info);
}

void visit_fields(FieldVisitor& visit, RsmGrid& grid) {
    // A preset is no state of its own: it is read off the values, and choosing one sets them.
    const std::size_t before = preset_of(grid);
    std::size_t chosen = before;
    visit.choice("preset", chosen, grid_preset_names,
                 {.help = "The paper's parameters, or those with which its figure 3-3 shows dividing lines."});
    if (chosen != before && chosen > 0) {
        grid = {.rsm_size = grid.rsm_size, .step = grid.step, .strength = grid_presets[chosen - 1].strength,
                .angle_threshold = grid_presets[chosen - 1].angle_threshold};
    }
    visit.field("rsm_size", grid.rsm_size, rsm_size_info);
    visit.field("step", grid.step,
                {.min = 1, .max = 64, .unit = "texels", .help = "Distance between texels that are read; more is cheaper and blotchier."});
    visit.field("strength", grid.strength, {.min = 0, .max = 10, .help = "The paper's RSM_STRENGTH: factor on the sum."});
    visit.field("angle_threshold", grid.angle_threshold,
                {.min = 0, .max = 1, .help = "Texels under this cosine are dropped at once; more makes hard lines at wall feet."});
    visit.field("distance_attenuation", grid.distance_attenuation,
                {.min = 0, .max = 1000, .unit = "1/m²", .help = "k in 1 / (1 + k distance²); more keeps bounced light nearer to its source."});
    visit.field("cutoff", grid.cutoff,
                {.min = 0, .max = 1, .help = "Texels attenuated below this are dropped at once; more is cheaper and shows arcs."});
}

void visit_fields(FieldVisitor& visit, RsmDisc& disc) {
    visit.field("rsm_size", disc.rsm_size, rsm_size_info);
    visit.field("samples", disc.samples,
                {.min = 0, .max = 4096, .help = "Texels read per gathering pixel, shared by all lights; more lowers noise and costs in proportion."});
    visit.field("radius", disc.radius,
                {.min = 0, .max = 1.5, .unit = "map side",
                 .help = "Radius of the sampled disc round the receiver's projection; less is steadier nearby and misses far light."});
    visit.field("rotate", disc.rotate, {.help = "Turns the pattern per pixel: banding becomes noise."});
    visit.field("interpolate", disc.interpolate, {.help = "Gathers at low resolution and fills in where neighbours agree; off gathers everywhere."});
    visit.field("low_resolution", disc.low_resolution,
                {.min = 2, .max = 32, .unit = "pixels", .help = "Spacing of the low-resolution gather; more is cheaper and coarser."});
    visit.field("position_tolerance", disc.position_tolerance,
                {.min = 0, .max = 1, .help = "How far off a pixel's plane a neighbour may lie, as a share of its distance to the camera."});
    visit.field("normal_tolerance", disc.normal_tolerance,
                {.min = -1, .max = 1, .help = "Least cosine between a pixel's normal and a neighbour's that may stand in for it."});
    visit.field("strength", disc.strength, strength_info);
}

void visit_fields(FieldVisitor& visit, GiSettings& settings) {
    const std::size_t before = gi_method_index(settings.method);
    std::size_t index = before;
    const std::span<const std::string_view> names = gi_method_names();
    visit.choice("method", index, names, {.help = "How indirect light is computed; see `secondlight list methods`."});
    if (index != before) settings.method = make_gi_method(names[index]);
    settings.method.type().visit(visit, settings.method);
}

}  // namespace sl
