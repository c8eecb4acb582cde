// SPDX-License-Identifier: MIT
#include "engine/measure/convolve.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "engine/core/check.h"

namespace sl {

namespace {

std::size_t radius_of(const Taps& taps) {
    CHECK(taps.size() % 2 == 1, "a filter of {} taps has no middle", taps.size());
    return taps.size() / 2;
}

/// sum[x] += weight · in[x]; its own function so that the compiler sees the whole inner loop.
void add_scaled(float* __restrict sum, const float* __restrict in, float weight, std::size_t count) {
    for (std::size_t x = 0; x < count; ++x) sum[x] += weight * in[x];
}

void convolve_row(const float* in, float* out, std::size_t width, const Taps& taps, std::vector<float>& padded) {
    const std::size_t radius = radius_of(taps);
    padded.assign(width + 2 * radius, in[0]);
    std::copy_n(in, width, padded.begin() + static_cast<std::ptrdiff_t>(radius));
    std::fill(padded.end() - static_cast<std::ptrdiff_t>(radius), padded.end(), in[width - 1]);
    for (std::size_t i = 0; i < taps.size(); ++i)
        add_scaled(out, padded.data() + i, static_cast<float>(taps[i]), width);
}

}  // namespace

Plane convolve(const Plane& plane, const Taps& along_x, const Taps& along_y) {
    CHECK(plane.width > 0 && plane.height > 0, "an empty picture");
    const std::size_t width = plane.width, height = plane.height, radius = radius_of(along_y);
    Plane rows(plane.width, plane.height), result(plane.width, plane.height);
    const auto each_row = [&](auto&& body) { tbb::parallel_for(tbb::blocked_range<std::size_t>(0, height), body); };
    each_row([&](const tbb::blocked_range<std::size_t>& range) {
        std::vector<float> padded;
        for (std::size_t y = range.begin(); y < range.end(); ++y) {
            convolve_row(&plane.data[y * width], &rows.data[y * width], width, along_x, padded);
        }
    });
    each_row([&](const tbb::blocked_range<std::size_t>& range) {
        for (std::size_t y = range.begin(); y < range.end(); ++y) {
            for (std::size_t j = 0; j < along_y.size(); ++j) {
                const std::size_t from = std::clamp(y + j, radius, radius + height - 1) - radius;
                add_scaled(&result.data[y * width], &rows.data[from * width], static_cast<float>(along_y[j]), width);
            }
        }
    });
    return result;
}

}  // namespace sl
