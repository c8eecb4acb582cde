// SPDX-License-Identifier: MIT
#include "engine/core/field_random.h"

#include <array>

#include "engine/core/field_clamp.h"
#include "engine/core/field_range.h"

namespace sl {

namespace {

constexpr double open_end = 1000.0;
constexpr double share_of_limits = 1.0 / 16.0;
// A logarithmic range that begins at 0 reaches this far down.
constexpr double smallest_share = 1e-6;

}  // namespace

double RandomFields::uniform() {
    return static_cast<double>(hash_mix(seed_, ++count_) >> 11) * 0x1p-53;
}

double RandomFields::inside(const FieldInfo& info) {
    const bool open_below = info.min == std::numeric_limits<double>::lowest();
    const bool open_above = info.max == std::numeric_limits<double>::max();
    const double low = open_below ? std::min(-open_end, info.max) : info.min;
    const double high = open_above ? std::max(open_end, info.min) : info.max;
    const double pick = uniform();
    if (pick < share_of_limits) return low;
    if (pick > 1.0 - share_of_limits) return high;
    const double t = uniform();
    if (info.look == FieldLook::logarithmic && low >= 0.0 && high > 0.0) {
        const double start = std::max(low, high * smallest_share);
        return start * std::pow(high / start, t);
    }
    return low + (high - low) * t;
}

template <class Number>
Number RandomFields::number(FieldInfo info) {
    if (std::unsigned_integral<Number>) info.min = std::max(info.min, 0.0);
    const double picked = inside(info);
    const FieldRange<Number> range = field_range<Number>(info);
    const double rounded = std::integral<Number> ? std::round(picked) : picked;
    const double clamped =
        std::clamp(rounded, static_cast<double>(range.low), static_cast<double>(range.high));
    return static_cast<Number>(clamped);
}

void RandomFields::field(std::string_view, bool& value, const FieldInfo&) {
    value = uniform() < 0.5;
}
void RandomFields::field(std::string_view, std::int32_t& value, const FieldInfo& info) {
    value = number<std::int32_t>(info);
}
void RandomFields::field(std::string_view, std::uint32_t& value, const FieldInfo& info) {
    value = number<std::uint32_t>(info);
}
void RandomFields::field(std::string_view, float& value, const FieldInfo& info) {
    value = number<float>(info);
}
void RandomFields::field(std::string_view, double& value, const FieldInfo& info) {
    value = number<double>(info);
}
void RandomFields::field(std::string_view, vec2& value, const FieldInfo& info) {
    for (int axis = 0; axis < 2; ++axis) value[axis] = number<float>(info);
}
void RandomFields::field(std::string_view, vec3& value, const FieldInfo& info) {
    for (int axis = 0; axis < 3; ++axis) value[axis] = number<float>(info);
}
void RandomFields::field(std::string_view, dvec3& value, const FieldInfo& info) {
    for (int axis = 0; axis < 3; ++axis) value[axis] = number<double>(info);
}

void RandomFields::field(std::string_view, quat& value, const FieldInfo&) {
    // A point in the unit ball of four dimensions, moved to its surface, is evenly spread over rotations.
    quat candidate(1, 0, 0, 0);
    float square = 0.0f;
    do {
        for (int i = 0; i < 4; ++i) candidate[i] = static_cast<float>(2.0 * uniform() - 1.0);
        square = glm::dot(candidate, candidate);
    } while (square < 1e-4f || square > 1.0f);
    value = nearest_rotation(candidate);
}

void RandomFields::field(std::string_view, std::string&, const FieldInfo&) {}
void RandomFields::choice(std::string_view, std::size_t& index, std::span<const std::string_view> names,
                          const FieldInfo&) {
    index = static_cast<std::size_t>(uniform() * static_cast<double>(names.size()));
}

}  // namespace sl
