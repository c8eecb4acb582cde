// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "engine/measure/spread.h"
#include "game/app/headless.h"

namespace sl {

/// One of several sides that take turns in a measurement: its world, its renderer and what was measured of it.
struct BenchSide {
    App app;
    Renderer renderer{shader_folder()};
    RenderScene scene;
    std::vector<double> frames;                         ///< ms, whole frames without timers
    std::vector<double> gi;                             ///< ms, all passes for GI, and what the CPU traced for it
    std::vector<double> gi_anew;                        ///< the same where light has changed: nothing kept is of use
    std::map<std::string, std::vector<double>> passes;  ///< ms
    std::vector<std::string> order;                     ///< of the passes

    explicit BenchSide(App world) : app(std::move(world)) {}

    /// Draws one frame and finishes it; the camera turns a little each time, the same way on all sides, so that nothing
    /// that depends on the view may be reused. Returns ms. Throws Error when the scene has no active camera.
    double draw(uvec2 size, std::uint32_t frame, bool per_pass);
    /// One frame as a whole and one with each pass finished before the next.
    void measure(uvec2 size, std::uint32_t frame);
    /// One frame that must draw all maps and gather all light anew, with each pass finished before the next.
    void measure_anew(uvec2 size, std::uint32_t frame);

  private:
    double gi_time();

    Renderer::Result result_;
};

}  // namespace sl
