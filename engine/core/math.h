// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>

namespace sl {

using glm::dmat4;
using glm::dvec3;
using glm::ivec2;
using glm::ivec3;
using glm::mat3;
using glm::mat4;
using glm::quat;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

inline constexpr float pi = 3.14159265358979323846f;

/// Axis-aligned box, metres. Empty until something is added.
struct Bounds {
    vec3 low{std::numeric_limits<float>::max()};
    vec3 high{std::numeric_limits<float>::lowest()};

    bool empty() const { return low.x > high.x; }
    vec3 centre() const { return 0.5f * (low + high); }
    /// Half the diagonal; 0 when empty.
    float radius() const { return empty() ? 0.0f : 0.5f * glm::length(high - low); }
    /// Larger by as much on all sides; still empty when empty.
    Bounds grown(float margin) const { return empty() ? *this : Bounds{low - margin, high + margin}; }
    Bounds moved(vec3 offset) const { return {low + offset, high + offset}; }
    /// Sides belong to it.
    bool contains(vec3 point) const { return glm::all(glm::greaterThanEqual(point, low)) && glm::all(glm::lessThanEqual(point, high)); }
    /// Whether they share a point, be it of their sides alone.
    bool touches(const Bounds& other) const { return glm::all(glm::lessThanEqual(low, other.high)) && glm::all(glm::lessThanEqual(other.low, high)); }
    /// Whether the way from a point along `direction`, up to `farthest` of its lengths, passes through.
    bool meets(vec3 origin, vec3 direction, float farthest) const {
        float near = 0.0f, far = farthest;
        for (int axis = 0; axis < 3; ++axis) {
            const float inverse = 1.0f / direction[axis], a = (low[axis] - origin[axis]) * inverse, b = (high[axis] - origin[axis]) * inverse;
            // NaN, where a ray lies in a side's plane, leaves both as they are.
            near = std::max(near, std::min(a, b));
            far = std::min(far, std::max(a, b));
        }
        return near <= far;
    }
    /// Grows as far as is needed to contain it.
    void add(vec3 point) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void add(const Bounds& other) {
        if (!other.empty()) {
            add(other.low);
            add(other.high);
        }
    }
};

/// Of linear colours with the primaries of sRGB (Rec. 709).
inline float luminance(vec3 colour) { return glm::dot(colour, vec3(0.2126f, 0.7152f, 0.0722f)); }

/// The smallest axis-aligned box around a transformed box (Arvo 1990: per-axis interval arithmetic).
Bounds transformed(const Bounds& bounds, const mat4& matrix);

/// Perspective projection with reversed depth and no far plane: depth = near / distance, so float depth keeps a constant
/// relative precision at any distance and `near` costs nothing. fov_y in radians, near in metres.
mat4 reversed_infinite_perspective(float fov_y, float aspect, float near);

/// Orthographic projection with reversed depth: 1 at `near`, 0 at `far`. Extents and distances in metres.
mat4 reversed_orthographic(float half_width, float half_height, float near, float far);

/// View matrix looking along `forward` (need not be unit; -z of the view) from `eye`. Picks another up vector where the
/// given one is parallel to `forward`.
mat4 view_from_world(vec3 eye, vec3 forward, vec3 up);

/// Octahedral encoding of a unit vector into 2 x snorm16 (Cigolle et al. 2014). Axis directions are exact.
std::uint32_t pack_normal(vec3 normal);
/// Its inverse, of length 1.
vec3 unpack_normal(std::uint32_t packed);

/// Mixes `value` into a 64-bit hash (splitmix finaliser); order matters.
inline std::uint64_t hash_mix(std::uint64_t hash, std::uint64_t value) {
    hash ^= value + 0x9e3779b97f4a7c15ull + (hash << 6) + (hash >> 2);
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9ull;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebull;
    return hash ^ (hash >> 31);
}
/// Mixes the bytes of a plain value (no padding) into a hash.
std::uint64_t hash_bytes(std::uint64_t hash, const void* data, std::size_t bytes);

}  // namespace sl
