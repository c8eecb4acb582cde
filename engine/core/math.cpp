// SPDX-License-Identifier: MIT
#include "engine/core/math.h"

#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

namespace sl {

Bounds transformed(const Bounds& bounds, const mat4& matrix) {
    if (bounds.empty()) return bounds;
    const vec3 centre = vec3(matrix * vec4(bounds.centre(), 1.0f));
    const vec3 half = 0.5f * (bounds.high - bounds.low);
    vec3 extent(0.0f);
    for (int column = 0; column < 3; ++column) extent += glm::abs(vec3(matrix[column])) * half[column];
    return {centre - extent, centre + extent};
}

mat4 reversed_infinite_perspective(float fov_y, float aspect, float near) {
    const float focal = 1.0f / std::tan(0.5f * fov_y);
    mat4 clip_from_view(0.0f);
    clip_from_view[0][0] = focal / aspect;
    clip_from_view[1][1] = focal;
    clip_from_view[2][3] = -1.0f;
    clip_from_view[3][2] = near;
    return clip_from_view;
}

mat4 reversed_orthographic(float half_width, float half_height, float near, float far) {
    mat4 clip_from_view(1.0f);
    clip_from_view[0][0] = 1.0f / half_width;
    clip_from_view[1][1] = 1.0f / half_height;
    clip_from_view[2][2] = 1.0f / (far - near);
    clip_from_view[3][2] = far / (far - near);
    return clip_from_view;
}

mat4 view_from_world(vec3 eye, vec3 forward, vec3 up) {
    const vec3 backward = -glm::normalize(forward);
    if (glm::length(glm::cross(up, backward)) < 1e-3f * glm::length(up)) {
        up = std::abs(backward.x) < 0.5f ? vec3(1, 0, 0) : vec3(0, 0, 1);
    }
    const vec3 right = glm::normalize(glm::cross(up, backward));
    const vec3 true_up = glm::cross(backward, right);
    mat4 view(1.0f);
    for (int axis = 0; axis < 3; ++axis) {
        view[axis][0] = right[axis];
        view[axis][1] = true_up[axis];
        view[axis][2] = backward[axis];
    }
    view[3] = vec4(-glm::dot(right, eye), -glm::dot(true_up, eye), -glm::dot(backward, eye), 1.0f);
    return view;
}

std::uint32_t pack_normal(vec3 normal) {
    const float length_1 = std::abs(normal.x) + std::abs(normal.y) + std::abs(normal.z);
    vec2 folded = length_1 > 0.0f ? vec2(normal) / length_1 : vec2(0.0f);
    if (normal.z < 0.0f) {
        const vec2 sign(folded.x >= 0.0f ? 1.0f : -1.0f, folded.y >= 0.0f ? 1.0f : -1.0f);
        folded = (1.0f - glm::abs(vec2(folded.y, folded.x))) * sign;
    }
    return glm::packSnorm2x16(folded);
}

vec3 unpack_normal(std::uint32_t packed) {
    const vec2 folded = glm::unpackSnorm2x16(packed);
    vec3 normal(folded, 1.0f - std::abs(folded.x) - std::abs(folded.y));
    const float below = std::max(-normal.z, 0.0f);
    normal.x += normal.x >= 0.0f ? -below : below;
    normal.y += normal.y >= 0.0f ? -below : below;
    return glm::normalize(normal);
}

std::uint64_t hash_bytes(std::uint64_t hash, const void* data, std::size_t bytes) {
    const auto* byte = static_cast<const unsigned char*>(data);
    while (bytes >= sizeof(std::uint64_t)) {
        std::uint64_t word = 0;
        std::memcpy(&word, byte, sizeof word);
        hash = hash_mix(hash, word);
        byte += sizeof word;
        bytes -= sizeof word;
    }
    if (bytes > 0) {
        std::uint64_t word = 0;
        std::memcpy(&word, byte, bytes);
        hash = hash_mix(hash, word);
    }
    return hash;
}

}  // namespace sl
