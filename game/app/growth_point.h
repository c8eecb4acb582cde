// SPDX-License-Identifier: MIT
#pragma once

#include "engine/measure/spread.h"
#include "game/app/commands.h"

namespace sl {

/// One world, method and picture size of `bench growth`.
struct GrowthPoint {
    SceneChoice choice;        ///< the scene, unless there are `blocks`; the method and its settings
    uvec2 size{0};
    std::uint32_t lamps = 0;   ///< added round the camera
    std::uint64_t blocks = 0;  ///< hills of about as many in place of the scene
    std::uint32_t edits = 0;   ///< blocks placed before each frame
};

/// What one point costs.
struct GrowthCost {
    std::string renderer;        ///< what draws
    Spread gi_ms;                ///< of frames in a window while the camera moves
    double anew_ms = 0.0;        ///< GI from nothing until everything that is wanted is known
    double behind = 0.0;         ///< NRMSE of the last frame's irradiance against what it comes to when all stops
    double catch_up_ms = 0.0;    ///< GI until it has come to that
    double memory_mb = 0.0;      ///< that the method took beyond what the frame takes without it
    std::uint64_t blocks = 0;    ///< that there are
    std::uint64_t triangles = 0;  ///< of their meshes
};

/// Makes a context and measures. Throws Error where the method cannot do it.
GrowthCost measure_growth(const GlobalFlags& global, const GrowthPoint& point);

}  // namespace sl
