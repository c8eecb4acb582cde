// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "engine/measure/convolve.h"

// The filters of ꟻLIP, for a screen of so many pixels per degree of visual angle.

namespace sl {

/// What the eye's contrast sensitivity leaves of the opponent channels Y, Cx, Cz (in this order).
std::array<Plane, 3> through_the_eye(const std::array<Plane, 3>& opponent, double pixels_per_degree);

/// Strength of edges and of points (or thin lines) in a lightness picture, both from 0.
struct Features {
    Plane edges;
    Plane points;
};
/// `lightness` from 0 to 1.
Features features_of(const Plane& lightness, double pixels_per_degree);

}  // namespace sl
