// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace sl::closed_form {

/// Form factors from a point receiver to a uniform Lambertian emitter (Siegel & Howell, view factors from a differential
/// element): irradiance is radiosity times form factor.

/// Receiver parallel to a rectangle a × b at distance c, below one of its corners.
inline double parallel_corner(double a, double b, double c) {
    const double x = a / c, y = b / c, rx = std::sqrt(1 + x * x), ry = std::sqrt(1 + y * y);
    return (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry)) / (2 * M_PI);
}

/// The same below any point: four corners with signs. Sides are measured from the receiver's foot.
inline double parallel(double left, double right, double near, double far, double c) {
    const auto corner = [&](double a, double b) { return std::copysign(1.0, a) * std::copysign(1.0, b) * parallel_corner(std::abs(a), std::abs(b), c); };
    return corner(right, far) - corner(left, far) - corner(right, near) + corner(left, near);
}

/// Receiver facing along a wall's foot: height a, width b starting opposite the receiver, distance c.
inline double perpendicular_half(double a, double b, double c) {
    const double x = a / b, y = c / b, r = std::sqrt(x * x + y * y);
    return (std::atan(1 / y) - y / r * std::atan(1 / r)) / (2 * M_PI);
}

/// The same for a wall from `left` to `right`, measured from the receiver's foot.
inline double perpendicular(double left, double right, double height, double c) {
    const auto half = [&](double b) { return std::copysign(1.0, b) * perpendicular_half(height, std::abs(b), c); };
    return half(right) - half(left);
}

/// A disc of radius r at distance h, parallel, on its axis.
inline double disc(double r, double h) { return r * r / (r * r + h * h); }

}  // namespace sl::closed_form
