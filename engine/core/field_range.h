// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <concepts>
#include <optional>

#include "engine/core/fields.h"

namespace sl {

/// Both ends are inside.
template <class T>
struct FieldRange {
    T low, high;
};

/// A field's range in its own type. The limits are rounded to the type, so that a float that shows as the
/// limit (0.7) is inside although its digits (0.69999998…) differ from the limit's.
template <class T>
FieldRange<T> field_range(const FieldInfo& info) {
    constexpr auto lowest = static_cast<double>(std::numeric_limits<T>::lowest());
    constexpr auto highest = static_cast<double>(std::numeric_limits<T>::max());
    const double low = std::clamp(info.min, lowest, highest);
    const double high = std::clamp(info.max, lowest, highest);
    if constexpr (std::integral<T>) {
        return {static_cast<T>(std::ceil(low)), static_cast<T>(std::floor(high))};
    } else {
        return {static_cast<T>(low), static_cast<T>(high)};
    }
}

/// The number as T, or nothing where it is outside the range, not finite or (for whole types) not whole.
template <class T>
std::optional<T> inside_range(double number, const FieldInfo& info) {
    if (!std::isfinite(number) || (std::integral<T> && std::trunc(number) != number)) return std::nullopt;
    if constexpr (std::integral<T>) {
        if (number < static_cast<double>(std::numeric_limits<T>::lowest())) return std::nullopt;
        if (number > static_cast<double>(std::numeric_limits<T>::max())) return std::nullopt;
    }
    const FieldRange<T> range = field_range<T>(info);
    // A double too large for a float becomes infinite and is outside.
    const T value = static_cast<T>(number);
    return value >= range.low && value <= range.high ? std::optional<T>(value) : std::nullopt;
}

/// The nearest value inside the range; not-a-number becomes the one nearest to 0.
template <class T>
T clamped_to_range(T value, const FieldInfo& info) {
    const FieldRange<T> range = field_range<T>(info);
    if constexpr (std::floating_point<T>) {
        if (std::isnan(value)) value = T{0};
    }
    return std::clamp(value, range.low, range.high);
}

/// "0.001 to 1.5533 rad", "at least 0 m", "at most 4", or "finite" without limits.
template <class T>
std::string range_text(const FieldInfo& info) {
    const bool has_low = std::integral<T> || info.min > std::numeric_limits<T>::lowest();
    const bool has_high = std::integral<T> || info.max < std::numeric_limits<T>::max();
    const double low = std::integral<T> ? static_cast<double>(field_range<T>(info).low) : info.min;
    const double high = std::integral<T> ? static_cast<double>(field_range<T>(info).high) : info.max;
    const std::string unit = info.unit.empty() ? "" : fmt::format(" {}", info.unit);
    if (has_low && has_high) return fmt::format("{} to {}{}", low, high, unit);
    if (has_low) return fmt::format("at least {}{}", low, unit);
    if (has_high) return fmt::format("at most {}{}", high, unit);
    return "finite";
}

}  // namespace sl
