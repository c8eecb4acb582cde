// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "engine/core/image.h"
#include "shared/frame.h"

namespace sl {

/// One frame of a still world along a camera's path. All images are of one size.
struct PathFrame {
    FrameParams view;  ///< the camera; all frames of a path have one origin
    Image depth;       ///< one channel, reversed: near / distance; 0 is the background
    Image normal;      ///< three channels, unit length
    Image value;       ///< three channels or more, linear: what should stand still on the surfaces
    Image error{};     ///< as `value`: one sample of its random error, where that is known; else empty
};

/// Pixels of a frame that show the surroundings of one point, and their shares, which add up to 1.
struct Footprint {
    std::array<std::size_t, 4> pixels{};
    std::array<float, 4> shares{};
};

/// The point that a pixel's middle shows.
vec3 seen_position(const PathFrame& frame, uvec2 pixel);

/// Where a frame shows a point of a surface, bilinear; none where it is out of the picture, or where one of the pixels
/// shows another surface: one that lies off the point's plane or is turned away from it.
std::optional<Footprint> find_point(const PathFrame& frame, vec3 position, vec3 normal);

/// How much a value that should stand still moves, per pixel of the path's middle frame. Maps have one channel and are
/// fractions of the pixel's mean luminance over the frames that show its surface (plus 1 % of the mean of the picture,
/// which keeps dark pixels finite).
struct Flicker {
    Image deviation;          ///< standard deviation over these frames
    Image change;             ///< root mean square of the differences of successive frames
    std::vector<float> mask;  ///< 1 where at least half of the frames show the surface
    double deviation_of_error = 0.0;  ///< RMS over pixels that the frames' known errors alone would have; 0: not known
    double change_of_error = 0.0;
    std::size_t samples = 0;  ///< pixels times the frames that show them
    double unlit = 0.0;       ///< share of the surface pixels of all frames that are exactly 0
};

/// At least two frames. Throws Error where a value on a surface is not finite.
Flicker flicker(const std::vector<PathFrame>& frames);

/// A map over the pixels that count.
struct FlickerFigures {
    double rms = 0.0, median = 0.0, p99 = 0.0;
    std::size_t pixels = 0;
};
/// Of the pixels whose mask is not 0; an empty mask counts all.
FlickerFigures flicker_figures(const Image& map, const std::vector<float>& mask);

/// What is left of a root mean square when that of an independent error is taken out; 0 where the error is all of it.
double less_error(double rms, double rms_of_error);

}  // namespace sl
