// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/core/image.h"

namespace sl {

/// How a map of errors is drawn.
struct HeatMapSettings {
    std::string title;     ///< what the map shows, for the legend
    double top = 1.0;      ///< the value of the ramp's bright end; above 0, and values beyond look the same as it
    bool percent = false;  ///< label 0.5 as 50%
};

/// The ramp's colour for 0 … 1, sRGB-encoded: black-blue, violet, red, orange, yellow, cream. Our own; lightness (CIE
/// L*) rises evenly with `value` to within 1.5 of 98, so the order is kept in grey and for every kind of colour
/// blindness.
vec3 heat_colour(float value);

/// False colours of a one-channel map, sRGB-encoded RGB, with a legend under it: the title and a bar with labelled
/// ticks. Pixels where `mask` (empty, or one value per pixel) is 0 are grey, and the legend says so. A map narrower
/// than its legend stands at the left of a wider picture.
Image heat_map(const Image& map, const std::vector<float>& mask, const HeatMapSettings& settings);

/// A round value (1, 2 or 5 times a power of ten) that 95 % of the pixels stay under; 1 where that is 0 or
/// infinite.
double suggested_top(const Image& map, const std::vector<float>& mask);

}  // namespace sl
