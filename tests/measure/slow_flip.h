// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "engine/core/image.h"

// ꟻLIP once more, as the paper's formulas stand there: two-dimensional filters applied pixel by pixel in double, and
// the sRGB matrix as printed in the standard. Shares no code with engine/measure/.

namespace sl::slow {

using Colour = std::array<double, 3>;
using Filter = std::function<double(int, int)>;
using Picture = std::function<double(int, int)>;

inline Colour relative_xyz(const Colour& c) {
    return {(0.4124564 * c[0] + 0.3575761 * c[1] + 0.1804375 * c[2]) / 0.95047,
            0.2126729 * c[0] + 0.7151522 * c[1] + 0.0721750 * c[2],
            (0.0193339 * c[0] + 0.1191920 * c[1] + 0.9503041 * c[2]) / 1.08883};
}

inline Colour linear_rgb(double x, double y, double z) {
    x *= 0.95047;
    z *= 1.08883;
    return {3.2404542 * x - 1.5371385 * y - 0.4985314 * z, -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
            0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
}

inline Colour hunt_lab(const Colour& linear) {
    const auto f = [](double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; };
    const Colour xyz = relative_xyz(linear);
    const double lightness = 116.0 * f(xyz[1]) - 16.0;
    return {lightness, 0.01 * lightness * 500.0 * (f(xyz[0]) - f(xyz[1])),
            0.01 * lightness * 200.0 * (f(xyz[1]) - f(xyz[2]))};
}

inline double hyab(const Colour& a, const Colour& b) {
    return std::abs(a[0] - b[0]) + std::sqrt(std::pow(a[1] - b[1], 2) + std::pow(a[2] - b[2], 2));
}

/// The filter's weights are divided by the sum of the positive ones, and the negative by that of the negative ones.
inline double convolved(const Picture& picture, const Filter& filter, int radius, int x, int y) {
    double positive = 0, negative = 0, sum_positive = 0, sum_negative = 0;
    for (int j = -radius; j <= radius; ++j) {
        for (int i = -radius; i <= radius; ++i) {
            const double weight = filter(i, j);
            (weight > 0 ? positive : negative) += std::abs(weight);
            (weight > 0 ? sum_positive : sum_negative) += weight * picture(x + i, y + j);
        }
    }
    return sum_positive / positive + (negative > 0 ? sum_negative / negative : 0.0);
}

struct View {
    const Image& image;
    double pixels_per_degree;

    Colour linear(int x, int y) const {
        const float* p = image.pixel(static_cast<std::uint32_t>(std::clamp(x, 0, static_cast<int>(image.width) - 1)),
                                     static_cast<std::uint32_t>(std::clamp(y, 0, static_cast<int>(image.height) - 1)));
        Colour result;
        for (std::size_t c = 0; c < 3; ++c) {
            const double v = p[c];
            result[c] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
        }
        return result;
    }
    Colour lab(int x, int y) const {
        const double pi2 = M_PI * M_PI;
        const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi2)) * pixels_per_degree));
        const auto bell = [&](double a, double b, int i, int j) {
            const double d2 = (i * i + j * j) / (pixels_per_degree * pixels_per_degree);
            return a * std::sqrt(M_PI / b) * std::exp(-pi2 * d2 / b);
        };
        const auto seen = [&](auto channel, const Filter& filter) {
            return convolved([&](int u, int v) { return channel(relative_xyz(linear(u, v))); }, filter, radius, x, y);
        };
        const double yy =
            seen([](const Colour& c) { return 116 * c[1] - 16; }, [&](int i, int j) { return bell(1, 0.0047, i, j); });
        const double cx = seen([](const Colour& c) { return 500 * (c[0] - c[1]); },
                               [&](int i, int j) { return bell(1, 0.0053, i, j); });
        const double cz = seen([](const Colour& c) { return 200 * (c[1] - c[2]); },
                               [&](int i, int j) { return bell(34.1, 0.04, i, j) + bell(13.5, 0.025, i, j); });
        const double luminance = (yy + 16) / 116;
        Colour result = linear_rgb(luminance + cx / 500, luminance, luminance - cz / 200);
        for (double& c : result) c = std::clamp(c, 0.0, 1.0);
        return hunt_lab(result);
    }
    /// {edge, point} strength.
    std::array<double, 2> features(int x, int y) const {
        const double deviation = 0.5 * 0.082 * pixels_per_degree;
        const int radius = static_cast<int>(std::ceil(3 * deviation));
        const auto bell = [&](int i, int j) { return std::exp(-(i * i + j * j) / (2 * deviation * deviation)); };
        const auto strength = [&](const std::function<double(double)>& across) {
            const Picture luminance = [&](int u, int v) { return relative_xyz(linear(u, v))[1]; };
            return std::hypot(convolved(
                                  luminance, [&](int i, int j) { return across(i) * bell(i, j); }, radius, x, y),
                              convolved(
                                  luminance, [&](int i, int j) { return across(j) * bell(i, j); }, radius, x, y));
        };
        return {strength([](double i) { return -i; }),
                strength([&](double i) { return i * i / (deviation * deviation) - 1; })};
    }
};

/// The value at one pixel.
inline double flip(const Image& image, const Image& reference, double pixels_per_degree, int x, int y) {
    const View a{image, pixels_per_degree}, b{reference, pixels_per_degree};
    const double largest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), 0.7);
    const double difference = std::pow(hyab(a.lab(x, y), b.lab(x, y)), 0.7), knee = 0.4 * largest;
    const double colour =
        difference < knee ? 0.95 * difference / knee : 0.95 + 0.05 * (difference - knee) / (largest - knee);
    const auto fa = a.features(x, y), fb = b.features(x, y);
    const double feature = std::sqrt(std::max(std::abs(fa[0] - fb[0]), std::abs(fa[1] - fb[1])) / std::sqrt(2.0));
    return std::pow(colour, 1 - feature);
}

}  // namespace sl::slow
