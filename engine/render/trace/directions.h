// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/math.h"
#include "shared/brdf.h"

namespace sl {

/// An orthonormal basis whose third axis is `axis` (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
inline mat3 basis_around(vec3 axis) {
    const float sign = std::copysign(1.0f, axis.z);
    const float a = -1.0f / (sign + axis.z);
    const float b = axis.x * axis.y * a;
    return mat3(vec3(1.0f + sign * axis.x * axis.x * a, sign * b, -sign * axis.x), vec3(b, sign + axis.y * axis.y * a, -axis.y), axis);
}

/// A direction of the hemisphere round +z with density cos θ / π (Malley's method).
inline vec3 cosine_direction(vec2 xi) {
    const float radius = std::sqrt(xi.x), angle = 2.0f * pi * xi.y;
    return vec3(radius * std::cos(angle), radius * std::sin(angle), std::sqrt(std::max(0.0f, 1.0f - xi.x)));
}

/// A direction of the cone round +z, evenly spread over its solid angle; `below` is versine · xi: 1 - cos of the angle to the axis.
/// Keeps its digits in cones so narrow that all their cosines are 1 in float.
inline vec3 cone_direction(float below, float turn) {
    const float sine = std::sqrt(std::max(below * (2.0f - below), 0.0f)), angle = 2.0f * pi * turn;
    return vec3(sine * std::cos(angle), sine * std::sin(angle), 1.0f - below);
}

/// Which lobes a direction is drawn from at a surface, and the density of that mixture.
struct DirectionSampler {
    mat3 basis;
    vec3 to_eye;          ///< in the basis
    float diffuse_share;  ///< of the cosine lobe; the rest follows the specular lobe
    float alpha;

    /// `least_diffuse`: what the cosine lobe gets in any case, 0 to 1.
    DirectionSampler(const Surface& surface, vec3 to_eye_world, bool diffuse_only, float least_diffuse)
        : basis(basis_around(vec3(surface.normal))), to_eye(glm::transpose(basis) * to_eye_world) {
        const float metallic = surface.normal.w;
        const bool matte = diffuse_only || specular_strength(surface) <= 0.0f || to_eye.z <= 0.0f;
        diffuse_share = matte ? 1.0f : std::max(least_diffuse, 0.5f * (1.0f - metallic));
        alpha = ggx_alpha(surface.base_colour.w);
    }

    /// A unit direction in world space; it may point below the surface.
    vec3 sample(vec2 xi) const {
        if (xi.x < diffuse_share) return basis * cosine_direction(vec2(xi.x / diffuse_share, xi.y));
        const vec3 half = visible_normal(vec2((xi.x - diffuse_share) / (1.0f - diffuse_share), xi.y));
        return basis * (2.0f * glm::dot(to_eye, half) * half - to_eye);
    }

    float density(vec3 direction_world) const {
        const vec3 direction = glm::transpose(basis) * direction_world;
        if (direction.z <= 0.0f) return 0.0f;
        float result = diffuse_share * direction.z / pi;
        if (diffuse_share < 1.0f) result += (1.0f - diffuse_share) * specular_density(direction);
        return result;
    }

  private:
    /// A normal of the Trowbridge-Reitz distribution as the eye sees it (Heitz 2018).
    vec3 visible_normal(vec2 xi) const {
        const vec3 stretched = glm::normalize(vec3(alpha * to_eye.x, alpha * to_eye.y, to_eye.z));
        const mat3 around = basis_around(stretched);
        const float radius = std::sqrt(xi.x), angle = 2.0f * pi * xi.y;
        const float s = 0.5f * (1.0f + stretched.z);
        // The disc's second half is squeezed to what the eye sees of it: along the axis that leans towards +z.
        const vec3 across = stretched.z < 0.9999f ? glm::normalize(glm::cross(vec3(0, 0, 1), stretched)) : around[0];
        const vec3 along = glm::cross(stretched, across);
        const float t1 = radius * std::cos(angle);
        const float t2 = (1.0f - s) * std::sqrt(std::max(0.0f, 1.0f - t1 * t1)) + s * radius * std::sin(angle);
        const vec3 normal = t1 * across + t2 * along + std::sqrt(std::max(0.0f, 1.0f - t1 * t1 - t2 * t2)) * stretched;
        return glm::normalize(vec3(alpha * normal.x, alpha * normal.y, std::max(0.0f, normal.z)));
    }
    float specular_density(vec3 direction) const {
        const vec3 half = glm::normalize(direction + to_eye);
        if (half.z <= 0.0f) return 0.0f;
        const float a2 = alpha * alpha;
        const vec3 sine = glm::cross(vec3(0, 0, 1), half);
        const float spread = glm::dot(sine, sine) + a2 * half.z * half.z;
        const float distribution = a2 / (pi * spread * spread);
        // G₁(v) D(h) ⟨v,h⟩ / v.z over 4 ⟨v,h⟩.
        const float seen = 2.0f * to_eye.z / (to_eye.z + std::sqrt(a2 + (1.0f - a2) * to_eye.z * to_eye.z));
        return seen * distribution / (4.0f * to_eye.z);
    }
};

}  // namespace sl
