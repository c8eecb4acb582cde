// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

namespace sl {

/// One channel of a picture: data[y * width + x].
struct Plane {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<float> data;

    Plane() = default;
    Plane(std::uint32_t width_, std::uint32_t height_)
        : width(width_), height(height_), data(std::size_t{width_} * height_) {}
};

/// Weights of a filter along one axis: 2 · radius + 1 of them, the first for the pixel `radius` places to the left.
using Taps = std::vector<double>;

/// The picture seen through the filter along_x ⊗ along_y: out(x, y) = Σ along_x[i] · along_y[j] · in(x + i − r, y + j −
/// r). Beyond its edge the picture goes on with its edge's values. Rows are shared among the processor's cores; the
/// result does not depend on their number.
Plane convolve(const Plane& plane, const Taps& along_x, const Taps& along_y);

}  // namespace sl
