// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <limits>

#include "engine/core/gltf/gltf_value.h"

namespace sl {

/// Bounds for numbers of a file, which are double.
struct FloatRange {
    float low = std::numeric_limits<float>::lowest();
    float high = std::numeric_limits<float>::max();
};

inline float gltf_float(double value, FloatRange range = {}) {
    return static_cast<float>(std::clamp(value, double{range.low}, double{range.high}));
}

/// The number at a key of a checked document.
inline float gltf_float_at(const nlohmann::json& object, std::string_view key, float otherwise, FloatRange range = {}) {
    return gltf_float(gltf_number_at(object, key, double{otherwise}), range);
}

/// The numbers of the array at a key, as many as the vector has; what is not there stays as it is.
template <class Vector>
void take_gltf_numbers(const nlohmann::json& object, std::string_view key, Vector& into, FloatRange range = {}) {
    const nlohmann::json& list = gltf_list(object, key);
    const auto count = std::min<std::size_t>(list.size(), static_cast<std::size_t>(Vector::length()));
    for (std::size_t i = 0; i < count; ++i) into[static_cast<int>(i)] = gltf_float(list[i].get<double>(), range);
}

}  // namespace sl
