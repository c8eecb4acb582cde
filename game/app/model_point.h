// SPDX-License-Identifier: MIT
#pragma once

#include "game/app/commands.h"

namespace sl {

/// One model of `bench models`, as its scene shows it.
struct ModelPoint {
    SceneChoice choice;
    std::filesystem::path folder;  ///< where its pictures go
    uvec2 size{0};                 ///< of the capture that is timed
    uvec2 reference_size{0};       ///< of those that are compared
    std::uint32_t spp = 0;         ///< of the reference
};

// Each of these is for a process that has done nothing else.

struct ModelLoad {
    double load_s = 0.0;          ///< until all of it is there to be drawn
    std::uint64_t triangles = 0;  ///< as they are drawn
};
/// Throws Error where there is nothing to draw.
ModelLoad measure_model_load(const ModelPoint& point);

struct CaptureCost {
    double capture_s = 0.0;  ///< the whole capture: loading, a context, indirect light from nothing, the picture's file
    double peak_mb = 0.0;    ///< the most that the process held
};
/// Keeps capture.png.
CaptureCost measure_model_capture(const GlobalFlags& global, const ModelPoint& point);

/// Of irradiance, against the path-traced full transport; see ErrorMetrics.
struct ModelErrors {
    double nrmse = 0.0, bias = 0.0;
    double reference_noise = 0.0;  ///< NRMSE of the reference itself
    double flip = 0.0;             ///< of the picture, against the reference's
};
/// Draws and traces the same small picture, and keeps both beside each other as beside_reference.png, and the reference, which
/// goes on from there the next time.
ModelErrors measure_model_errors(const GlobalFlags& global, const ModelPoint& point);

}  // namespace sl
