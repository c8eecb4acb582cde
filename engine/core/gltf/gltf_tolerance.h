// SPDX-License-Identifier: MIT
#pragma once

/// How far numbers may be from what they should be: as far as they come when stored in 8 bits.
namespace sl::gltf_tolerance {

inline constexpr double unit_vector = 0.00674;
inline constexpr double unit_quaternion = 0.00769;
inline constexpr double upright = 0.005;     ///< cosine between columns of a matrix
inline constexpr double matrix_row = 1e-6;   ///< of the last row of a matrix
inline constexpr double weight_sum = 2e-7;   ///< per weight that is not 0, in float32

}  // namespace sl::gltf_tolerance
