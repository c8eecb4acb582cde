// SPDX-License-Identifier: MIT
#pragma once

// What makes one text valid in C++ and GLSL. Shared headers use vec2/3/4, uvec4, mat4, float and uint only; structs hold
// no bool, no mat3 and no bare vec3, so that C++ and both GL layouts agree without padding rules.
#ifdef __cplusplus
#include <glm/glm.hpp>
#define SHARED_BEGIN namespace sl {
#define SHARED_END }
#define SHARED_FN inline
SHARED_BEGIN
/// As GLSL calls it.
using uint = std::uint32_t;
using glm::abs;
using glm::atan;
using glm::ceil;
using glm::clamp;
using glm::cos;
using glm::cross;
using glm::dot;
using glm::exp;
using glm::exp2;
using glm::floatBitsToUint;
using glm::floor;
using glm::length;
using glm::log2;
using glm::mat4;
using glm::max;
using glm::min;
using glm::mix;
using glm::normalize;
using glm::pow;
using glm::round;
using glm::sqrt;
using glm::uintBitsToFloat;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
SHARED_END
#else
#define SHARED_BEGIN
#define SHARED_END
#define SHARED_FN
#endif
