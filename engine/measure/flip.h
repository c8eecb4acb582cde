// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/image.h"

namespace sl {

/// How different two pictures look when one alternates with the other at the same place.
struct Flip {
    Image map;          ///< one channel, 0 (same) to 1 (black against white and more)
    double mean = 0.0;  ///< of the map, over the pixels that the mask leaves
};

/// A screen of 0.7 m and 3840 pixels across, seen from 0.7 m: the paper's default.
inline constexpr float usual_pixels_per_degree = 67.0f;

/// LDR-ꟻLIP of two sRGB-encoded pictures of one size, at least 3 channels; values beyond [0, 1] are clamped, as a
/// screen does. `mask` is empty or has one value per pixel; pixels where it is 0 count as black in both pictures, and
/// not in the mean. `pixels_per_degree` (of visual angle) is at least 1. Symmetric in the two pictures. Throws Error
/// for pixels that are not finite. Andersson, Nilsson, Akenine-Möller, Oskarsson, Åström, Fairchild: FLIP: A Difference
/// Evaluator for Alternating Images, High-Performance Graphics 2020.
Flip flip(const Image& image, const Image& reference, const std::vector<float>& mask = {},
          float pixels_per_degree = usual_pixels_per_degree);

}  // namespace sl
