// SPDX-License-Identifier: MIT
#include "engine/measure/flip_filters.h"

#include <cmath>
#include <numbers>

namespace sl {

namespace {

constexpr double pi_squared = std::numbers::pi * std::numbers::pi;

/// One term of a contrast sensitivity function's inverse Fourier transform: amplitude · √(π/b) · exp(−π² d² / b), d in
/// degrees.
struct Bell {
    double amplitude = 0.0;
    double b = 1.0;
};
/// Table 1 of the paper: Y, Cx and Cz as sums of bells.
constexpr std::array<std::array<Bell, 2>, 3> sensitivity{
    {{{{1.0, 0.0047}, {}}}, {{{1.0, 0.0053}, {}}}, {{{34.1, 0.04}, {13.5, 0.025}}}}};
constexpr double widest_b = 0.04;

constexpr double feature_width = 0.082;  // degrees: peak to trough of the eye's edge detector

template <class Weight>
Taps taps_of(int radius, Weight&& weight) {
    Taps taps;
    for (int i = -radius; i <= radius; ++i) taps.push_back(weight(static_cast<double>(i)));
    return taps;
}

double sum_of(const Taps& taps) {
    double sum = 0.0;
    for (const double tap : taps) sum += tap;
    return sum;
}

/// Scales positive weights to a sum of 1 and negative ones to −1.
Taps balanced(Taps taps) {
    double positive = 0.0, negative = 0.0;
    for (const double tap : taps) (tap > 0.0 ? positive : negative) += std::abs(tap);
    for (double& tap : taps) tap /= tap > 0.0 ? positive : negative;
    return taps;
}

Plane magnitude(const Plane& x, const Plane& y) {
    Plane result(x.width, x.height);
    for (std::size_t i = 0; i < result.data.size(); ++i) result.data[i] = std::hypot(x.data[i], y.data[i]);
    return result;
}

/// A sum of two-dimensional bells is no product of two filters along the axes, but each bell is: they are applied one
/// by one, each with the share that it has in the sum of all weights.
Plane through_bells(const Plane& plane, const std::array<Bell, 2>& bells, int radius, double pixels_per_degree) {
    std::array<Taps, 2> taps;
    std::array<double, 2> shares{};
    for (std::size_t k = 0; k < bells.size(); ++k) {
        taps[k] = taps_of(radius, [&](double x) {
            return std::exp(-pi_squared * x * x / (pixels_per_degree * pixels_per_degree * bells[k].b));
        });
        shares[k] = bells[k].amplitude * std::sqrt(std::numbers::pi / bells[k].b) * sum_of(taps[k]) * sum_of(taps[k]);
    }
    Plane result(plane.width, plane.height);
    for (std::size_t k = 0; k < bells.size(); ++k) {
        if (bells[k].amplitude == 0.0) continue;
        const double sum = sum_of(taps[k]);
        for (double& tap : taps[k]) tap /= sum;
        const Plane filtered = convolve(plane, taps[k], taps[k]);
        const auto share = static_cast<float>(shares[k] / (shares[0] + shares[1]));
        for (std::size_t i = 0; i < result.data.size(); ++i) result.data[i] += share * filtered.data[i];
    }
    return result;
}

}  // namespace

std::array<Plane, 3> through_the_eye(const std::array<Plane, 3>& opponent, double pixels_per_degree) {
    // Three standard deviations of the widest bell, for all.
    const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(widest_b / (2.0 * pi_squared)) * pixels_per_degree));
    std::array<Plane, 3> result;
    for (std::size_t c = 0; c < 3; ++c)
        result[c] = through_bells(opponent[c], sensitivity[c], radius, pixels_per_degree);
    return result;
}

Features features_of(const Plane& lightness, double pixels_per_degree) {
    const double deviation = 0.5 * feature_width * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3.0 * deviation));
    const auto bell = [&](double x) { return std::exp(-x * x / (2.0 * deviation * deviation)); };
    // Across: the first derivative finds edges, the second points. Along: a bell with sum 1.
    Taps along = taps_of(radius, bell);
    const double sum = sum_of(along);
    for (double& tap : along) tap /= sum;
    const Taps edge = balanced(taps_of(radius, [&](double x) { return -x * bell(x); }));
    const Taps point =
        balanced(taps_of(radius, [&](double x) { return (x * x / (deviation * deviation) - 1.0) * bell(x); }));
    return {magnitude(convolve(lightness, edge, along), convolve(lightness, along, edge)),
            magnitude(convolve(lightness, point, along), convolve(lightness, along, point))};
}

}  // namespace sl
