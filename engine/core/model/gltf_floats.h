// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "engine/core/gltf/gltf_value.h"

namespace sl {

/// Bounds for numbers of a file, which are double: squares of what lies within are floats too, and so are their sums.
struct FloatRange {
    float low = -1e18f;
    float high = 1e18f;
};

/// The nearest float within the range.
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
