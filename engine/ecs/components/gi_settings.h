// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <tuple>

#include "engine/ecs/components/gi_method.h"

namespace sl {

/// No indirect light: no RSM and no gather pass is scheduled.
struct GiOff {
    static constexpr std::string_view name = "off";
    static constexpr std::string_view claims = "direct light only";
};

/// Every texel of every RSM, without occlusion, in physical units: the yardstick for sampling error.
struct RsmExact {
    static constexpr std::string_view name = "rsm_exact";
    static constexpr std::string_view claims = "one diffuse bounce without occlusion, no sampling error";
    std::uint32_t rsm_size = 256;
    float strength = 1.0f;
};

/// The regular grid of "Global illumination based on RSM" (2024), Algorithm 1, kept with its artefacts.
struct RsmGrid {
    static constexpr std::string_view name = "rsm_grid";
    static constexpr std::string_view claims = "one bounce without occlusion, not in physical units";
    std::uint32_t rsm_size = 64;
    std::uint32_t step = 1;
    float strength = 0.3f;
    float angle_threshold = 0.01f;
    float distance_attenuation = 1.25f;
    float cutoff = 0.01f;
};

/// The importance-sampled disc of Dachsbacher & Stamminger, "Reflective Shadow Maps" (I3D 2005), in physical units,
/// with its screen-space interpolation.
struct RsmDisc {
    static constexpr std::string_view name = "rsm_disc";
    static constexpr std::string_view claims = "one diffuse bounce without occlusion";
    std::uint32_t rsm_size = 256;
    std::uint32_t samples = 320;
    float radius = 0.5f;
    bool rotate = false;
    bool interpolate = true;
    std::uint32_t low_resolution = 8;
    float position_tolerance = 0.05f;
    float normal_tolerance = 0.9f;
    float strength = 1.0f;
};

/// Irradiance gathered at the corners of facets on the visible surfaces, from patches on all surfaces, kept in world space.
struct Facets {
    static constexpr std::string_view name = "facets";
    static constexpr std::string_view claims = "all bounces of all lights, sky and glowing surfaces, with occlusion";
    float spacing = 8.0f;
    float noise = 0.07f;
    float budget_ms = 10.0f;
    std::uint32_t bounces = 64;
    float strength = 1.0f;
};

void visit_fields(FieldVisitor& visit, GiOff& off);
void visit_fields(FieldVisitor& visit, RsmExact& exact);
void visit_fields(FieldVisitor& visit, RsmGrid& grid);
void visit_fields(FieldVisitor& visit, RsmDisc& disc);
void visit_fields(FieldVisitor& visit, Facets& facets);

/// The engine's own methods. A new one: its settings struct and visit_fields above, one word here, gi/NAME.cpp and its shader.
/// A method of a program that uses the engine is added by add_gi_method instead (engine/render/gi/gi.h).
using EngineGiMethods = std::tuple<GiOff, RsmExact, RsmGrid, RsmDisc, Facets>;

/// How the camera's picture gets its indirect light. Without this component there is none.
struct GiSettings {
    GiMethod method = Facets{};
};

void visit_fields(FieldVisitor& visit, GiSettings& settings);

}  // namespace sl
