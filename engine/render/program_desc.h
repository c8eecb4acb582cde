// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <string>
#include <utility>
#include <vector>

namespace sl {

/// Which files make a program; paths are relative to the shader folder. Either compute alone, or vertex and
/// (optionally) fragment.
struct ProgramDesc {
    std::string vertex;
    std::string fragment;
    std::string compute;
    std::vector<std::pair<std::string, std::string>> defines;  ///< two switches at most per shader

    auto operator<=>(const ProgramDesc&) const = default;
};

/// How a pass looks at an image. nearest, linear: clamped, no mips. shadow_compare: linear comparison against reversed
/// depth, lit outside the map. pixel_art: repeats, sharp when close, mip-mapped when far. picture: repeats, smooth.
enum class Sampling { nearest, linear, shadow_compare, pixel_art, picture };

}  // namespace sl
