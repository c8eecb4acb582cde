// SPDX-License-Identifier: MIT
#include "engine/measure/flip_colour.h"

#include "engine/core/srgb.h"

#include <cmath>

namespace sl {

namespace {

using glm::dmat3;

/// XYZ of a chromaticity at Y = 1.
dvec3 xyz_of(double x, double y) {
    return {x / y, 1.0, (1.0 - x - y) / y};
}

/// The columns are the XYZ of the primaries, scaled so that their sum is the white point (SMPTE RP 177).
dmat3 xyz_from_linear_matrix() {
    const dmat3 primaries(xyz_of(0.64, 0.33), xyz_of(0.30, 0.60), xyz_of(0.15, 0.06));
    const dvec3 scale = glm::inverse(primaries) * xyz_of(0.3127, 0.3290);
    return dmat3(primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z);
}

/// XYZ over the white point's XYZ: white is (1, 1, 1).
dmat3 relative_xyz_from_linear_matrix() {
    const dmat3 xyz = xyz_from_linear_matrix();
    const dvec3 white = xyz * dvec3(1.0);
    dmat3 result = xyz;
    for (int column = 0; column < 3; ++column) result[column] /= white;
    return result;
}

const mat3 relative_xyz_from_linear(relative_xyz_from_linear_matrix());
const mat3 linear_from_relative_xyz(glm::inverse(relative_xyz_from_linear_matrix()));

/// CIELAB's cube root with its straight piece near black.
float lab_root(float t) {
    constexpr float knee = 6.0f / 29.0f;
    return t > knee * knee * knee ? std::cbrt(t) : t / (3.0f * knee * knee) + 4.0f / 29.0f;
}

}  // namespace

vec3 linear_from_srgb(vec3 encoded) {
    return {sl::linear_from_srgb(encoded.x), sl::linear_from_srgb(encoded.y), sl::linear_from_srgb(encoded.z)};
}

vec3 opponent_from_linear(vec3 linear) {
    const vec3 xyz = relative_xyz_from_linear * linear;
    return {116.0f * xyz.y - 16.0f, 500.0f * (xyz.x - xyz.y), 200.0f * (xyz.y - xyz.z)};
}

vec3 linear_from_opponent(vec3 opponent) {
    const float y = (opponent.x + 16.0f) / 116.0f;
    return linear_from_relative_xyz * vec3(y + opponent.y / 500.0f, y, y - opponent.z / 200.0f);
}

vec3 hunt_lab_from_linear(vec3 linear) {
    const vec3 xyz = relative_xyz_from_linear * linear;
    const vec3 root(lab_root(xyz.x), lab_root(xyz.y), lab_root(xyz.z));
    const float lightness = 116.0f * root.y - 16.0f;
    const float hunt = 0.01f * lightness;
    return {lightness, hunt * 500.0f * (root.x - root.y), hunt * 200.0f * (root.y - root.z)};
}

float hyab(vec3 a, vec3 b) {
    return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z);
}

}  // namespace sl
