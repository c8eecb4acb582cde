// SPDX-License-Identifier: MIT
#pragma once

#include "game/app/headless.h"

namespace sl {

/// A world drawn frame by frame as in a window, and what the last frame's GI took.
struct BenchWindow {
    App app;
    uvec2 size;
    Renderer renderer{shader_folder()};
    RenderScene scene{};
    std::uint32_t frame = 0;    ///< number of the next
    double milliseconds = 0.0;  ///< of all passes for GI, and what the CPU traced for it

    /// Runs the world's systems and draws: as much as a window does in a frame, or with `all` until everything that is
    /// wanted is known. Throws Error where the scene has no active camera.
    void draw(bool all);

    /// Of the last frame, top row first. A method without indirect light leaves one black pixel.
    Image irradiance() const { return read("irradiance"); }
    Image depth() const { return read("depth"); }
    /// Octahedral, as it is drawn.
    Image normal() const { return read("normal"); }

  private:
    Image read(const char* image) const { return renderer.read(renderer.find_image(image)); }
};

/// Moves the active camera to its right, m, and turns it to its left, rad.
void move_camera(World& world, double right, float angle);

/// A block on the surface that the camera sees in a direction: that much to its right and up at a distance of 1 before it.
/// None where it sees no block there.
void place_block(World& world, vec2 slope = vec2(0.0f));

}  // namespace sl
